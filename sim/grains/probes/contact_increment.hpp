// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What happened at a contact between two instants, as an observer sees who turns with it, and as
// one sees who rests.
//
// With F the force of b on a, ℓ the branch from a to b, r_a and r_b the arms from the centres to
// the contact, θ_a and θ_b the turns of the grains, φ that of the contact's frame, Δ the change and
// a bar the mean of both instants, Δu = Δℓ + θ_b × r̄_b − θ_a × r̄_a is the way of b's surface past
// a's and
//
//   in the turning frame   ΔF̂ · Δû = ΔF · Δu − (φ × F̄) · Δu          to the third order
//   in the frame at rest   ΔF · Δu = ΔF · Δℓ − θ_a · ΔM_a − θ_b · ΔM_b
//                                    + θ_a · (Δr_a × F̄) − θ_b · (Δr_b × F̄)
//
// where ΔM are the changes of the moments r_a × F and −r_b × F, which sum up to 0 on a grain that
// is in equilibrium at both instants.
#include <Eigen/Core>

namespace triax::sim {

/// One end of the interval, for grains a and b. A contact that is open has no forces.
struct ContactInstant {
  Eigen::Vector3d branch_m;      ///< from the centre of a to that of b
  double normal_force_n = 0;     ///< ≥ 0
  Eigen::Vector3d tangential_n;  ///< force of b on a
};

struct ContactIncrement {
  double normal_work = 0;      ///< ΔF_n Δδ_n, J
  double tangential_work = 0;  ///< ΔF_t · Δu_t, J
  double at_rest_work = 0;     ///< ΔF · Δℓ: grains as points in a frame at rest, J
  double frame_turning = 0;    ///< −(φ × F̄) · Δu, J
  double grain_turning = 0;    ///< θ_a · (Δr_a × F̄) − θ_b · (Δr_b × F̄), J
  Eigen::Vector3d force_change_n = Eigen::Vector3d::Zero();      ///< ΔF, on a
  Eigen::Vector3d moment_change_a_nm = Eigen::Vector3d::Zero();  ///< of r_a × F
  Eigen::Vector3d moment_change_b_nm = Eigen::Vector3d::Zero();  ///< of −r_b × F
};

/// Radii in m; `turn_a`, `turn_b` rotation vectors of the grains, rad. The contact frame turns with
/// the line of centres by the shortest way and about it with the mean twist of both grains; Δu_t is
/// what the grains' turns relative to that frame make at the contact, with arms that are the means
/// of both instants.
ContactIncrement contact_increment(const ContactInstant& before, const ContactInstant& after,
                                   double radius_a_m, double radius_b_m,
                                   const Eigen::Vector3d& turn_a, const Eigen::Vector3d& turn_b);

}  // namespace triax::sim
