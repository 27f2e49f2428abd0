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
// the whole adds nothing. Eq. (22):
//
//   W₂ = W̄₂ − 1/V Σ_{p∈∂V} F_ext · δ²u
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
  /// Σ F_ext · δ²u over grains at walls, with δ²u = change of their velocity × duration, which is
  /// all that two states tell. F_ext is the whole force, not its change: the rest of motion at a
  /// end at rest makes this larger than W₂ itself. A sign of motion, no correction; the paper
  /// neglects it.
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
