// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One sphere and what pulls at it, as rows of four doubles. Plain data, free of any library: this
// header is compiled for several instruction sets.

namespace triax::sim {

// NOLINTBEGIN(modernize-avoid-c-arrays): kernels load the rows as they lie
struct alignas(32) Grain {
  double position[3], radius;        ///< m
  double velocity[3], inverse_mass;  ///< m/s, half a step behind the position; 1/kg
  double spin[3], inverse_inertia;   ///< rad/s, as the velocity; 1/(kg m²)

  friend bool operator==(const Grain&, const Grain&) = default;
};
static_assert(sizeof(Grain) == 96);

struct alignas(64) GrainLoad {
  double force[3], force_pad;    ///< N
  double moment[3], moment_pad;  ///< N m about the centre
};
static_assert(sizeof(GrainLoad) == 64);
// NOLINTEND(modernize-avoid-c-arrays)

}  // namespace triax::sim
