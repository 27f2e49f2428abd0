// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a specimen of grains shows, computed from its state and never inside a step. Forces are
// those of the last step: they stand at the positions before it, x − Δt v, where the tangential
// forces belong, so that sums of forces are those that the grains were moved by.
//
// Compression positive, SI.
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

/// A contact of two grains (indices of state.grains), or of a grain and a wall (j = −1 − wall).
struct GrainContact {
  std::int32_t i = 0, j = 0;
  Eigen::Vector3d normal;     ///< from i to j, unit
  Eigen::Vector3d branch_m;   ///< from the centre of i to that of j, or to the wall
  Eigen::Vector3d force_n;    ///< on i
  double normal_force_n = 0;  ///< ≥ 0
  double tangential_force_n = 0;
  bool slides = false;  ///< at Coulomb's limit; no contact with a wall slides
};

std::vector<GrainContact> contacts_of(const GrainState& state);

struct GrainMeasures {
  double kinetic_energy_j = 0;
  double unbalanced =
      0;  ///< mean |resultant on a grain| over mean |contact force|; 0 without contact
  double void_ratio = 0, porosity = 0;
  double coordination = 0;  ///< (2 contacts of grains + contacts with walls)/grains
  std::int64_t grain_contacts = 0, wall_contacts = 0, sliding_contacts = 0;
  std::int64_t floating_grains = 0;        ///< without any contact
  std::int64_t grains_outside = 0;         ///< centre beyond a wall: has to be 0
  std::array<double, 3> wall_stress_pa{};  ///< mean of both walls of each axis
  Eigen::Matrix3d stress_pa;               ///< −1/V Σ f ⊗ branch, f on i, branch from i
};

GrainMeasures measure(const GrainState& state);

double kinetic_energy(const GrainState& state);
double porosity(const GrainState& state);

}  // namespace triax::sim
