// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Second-order work between two states of one specimen (Darve, Sibille, Daouadji and Nicot 2007,
// section 3), per volume of the first, J/m³. Compression positive; Δ is the second state minus the
// first. States are taken where their forces are known: one step before the positions
// (grain_measures.hpp).
//
//   semi-Lagrangian (7)   W₂ = 1/V Σ_walls Δf · Δu           f on the specimen, u of the wall
//   Eulerian (10)         W₂ = Δσ : LΔt + div(Δu) σ : LΔt − σ Lᵗ Δt : LΔt,  LΔt = natural strain
//   microscopic (11)      W̄₂ = 1/V Σ_contacts (ΔF_n Δδ_n + ΔF_t · Δu_t)
//
// with σ of the first state. Increments at a contact are taken in the frame that turns with it
// (with the line of centres, and about it with the mean turn of both grains), so that a motion of
// the whole adds nothing.
//
// The gap between both. Second-order work is what the power Σ F · u̇ of contacts and walls grows by.
// At a contact the power is the same in a frame at rest and in its own, and so is its growth:
//
//   Ḟ · u̇ + F · ü = F̂˙ · û˙ + F̂ · û¨
//
// summed up, as the grains are in equilibrium, W₂ = W̄₂ + Σ F̂ · û¨ − Σ F_ext · ü. Eq. (22) of the
// paper is this with F̂ · û¨ = 0 (its Eq. 21), which does not hold where grains roll and slide: the
// two sums are large and cancel each other but for the turning of contacts and of grains under the
// force that they carry. With the increments of contact_increment.hpp, to the third order,
//
//   W̄₂ = W₂ + contacts_turning + grains_turning + out_of_balance
//
//   contacts_turning   −1/V Σ (φ × F̄) · Δu
//   grains_turning      1/V Σ θ_a · (Δr_a × F̄) − θ_b · (Δr_b × F̄)
//   out_of_balance     −1/V Σ over grains ΔR · Δx + ΔM · θ      R, M: resultant force and moment
//
// where every term is computed for itself. `gap_left()` is what they leave.
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

struct GrainWork {
  double lagrangian = 0;  ///< Eq. (7)

  double stress_part = 0;     ///< Δσ : LΔt
  double volume_part = 0;     ///< div(Δu) σ : LΔt
  double transport_part = 0;  ///< −σ Lᵗ Δt : LΔt
  double eulerian() const { return stress_part + volume_part + transport_part; }  ///< Eq. (10)
  /// Δσ : LΔt/(|Δσ| |LΔt|), −1 to 1; 0 where nothing changed
  double normalised = 0;

  double normal_part = 0;         ///< of contacts in both states, walls included
  double tangential_part = 0;     ///< of contacts in both states
  double non_permanent_part = 0;  ///< of contacts in one of the two states only
  double microscopic() const { return normal_part + tangential_part + non_permanent_part; }
  /// 1/V Σ ΔF · Δ(x_b − x_a) over the same contacts in a frame at rest, grains as points: the
  /// Lagrangian sum itself wherever the forces of both states balance on every grain. What the
  /// microscopic sum differs by from this one is the turning of contacts and grains under the force
  /// that they carry.
  double fixed_frame = 0;
  /// Parts of the gap between the microscopic sum and Eq. (7), above.
  double contacts_turning = 0, grains_turning = 0, out_of_balance = 0;
  double gap() const { return microscopic() - lagrangian; }
  double gap_left() const { return gap() - contacts_turning - grains_turning - out_of_balance; }
  /// 1/V Σ F_ext · δ²u of Eq. (22) (boundary_term.hpp); it takes a state half-way: grain_work()
  /// leaves it 0.
  double boundary_part = 0;

  double kinetic_before_j = 0, kinetic_after_j = 0;
  std::int64_t contacts_before = 0;     ///< walls included
  std::int64_t opened = 0, closed = 0;  ///< in the first or the second state only
  std::int64_t slides_after = 0;        ///< at Coulomb's limit in the second state
  /// (opened + closed)/contacts before; 0 without contacts
  double non_permanent_share() const;

  std::array<double, 3> stress_change_pa{};  ///< of each axis of the box, on the walls
  std::array<double, 3> strain{};            ///< natural, compression positive
};

/// `turned` is how far each grain turned in between (grain_rotations.hpp). Throws
/// std::invalid_argument if the states are not of one specimen or `turned` not as long.
GrainWork grain_work(const GrainState& before, const GrainState& after,
                     const std::vector<Eigen::Vector3d>& turned);

/// Where forces are known: the box one step before the positions.
GrainBox box_of_forces(const GrainState& state);

}  // namespace triax::sim
