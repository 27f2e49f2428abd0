// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What happened at a contact between two instants, as an observer sees who turns with it.
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
};

/// Radii in m; `turn_a`, `turn_b` rotation vectors of the grains, rad. The contact frame turns with
/// the line of centres by the shortest way and about it with the mean twist of both grains; Δu_t is
/// what the grains' turns relative to that frame make at the contact, with arms that are the means
/// of both instants.
ContactIncrement contact_increment(const ContactInstant& before, const ContactInstant& after,
                                   double radius_a_m, double radius_b_m,
                                   const Eigen::Vector3d& turn_a, const Eigen::Vector3d& turn_b);

}  // namespace triax::sim
