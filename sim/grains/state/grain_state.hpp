// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Everything that decides how a specimen of spheres in a box of six rigid walls goes on: plain
// values that are copied, compared, saved and restored. A copy continues bit for bit as the
// original would, on any number of threads and with any instruction set.
//
// Grains stand in the order of the cells that they were last sorted into; `ids` says which is
// which. Time is staggered: velocities lie half a step behind the positions; tangential forces and
// the walls' forces are those of the last evaluation, one step behind the positions.
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/grains/state/aligned_vector.hpp"
#include "sim/grains/state/axis_drive.hpp"
#include "sim/grains/state/contact_law.hpp"
#include "sim/grains/state/grain.hpp"

namespace triax::sim {

/// A sphere at rest, as a specimen is described.
struct Sphere {
  std::array<double, 3> centre_m{};
  double radius_m = 0;
};

struct GrainBox {
  std::array<double, 3> low_m{}, high_m{};

  double length_m(int axis) const { return high_m[axis] - low_m[axis]; }
  /// Area of a wall across `axis`.
  double area_m2(int axis) const { return length_m((axis + 1) % 3) * length_m((axis + 2) % 3); }
  double volume_m3() const { return length_m(0) * area_m2(0); }
  friend bool operator==(const GrainBox&, const GrainBox&) = default;
};

/// The six walls; those of axis a are 2a (low) and 2a + 1 (high).
struct WallState {
  std::array<AxisDrive, 3> drive;
  std::array<double, 3> stress_target_pa{};    ///< of stress-driven axes: on its way to the goal
  std::array<double, 3> strain_rate_per_s{};   ///< now, as the servo smoothed it
  std::array<double, 3> learned_rate_per_s{};  ///< of servos: what they hold steadily (walls.hpp)
  std::array<double, 6> force_n{};             ///< the grains push each wall outwards with this
  std::array<double, 6> stiffness_n_per_m{};   ///< of the grains that touch it, summed
  friend bool operator==(const WallState&, const WallState&) = default;
};

/// How far beyond contact neighbours are listed. Only speed depends on it (results to round-off).
struct NeighbourMargin {
  double listed_m = 0;  ///< pairs with a smaller gap are listed when grains are sorted
  double near_m = 0;    ///< of those, the ones that are visited in every step; below listed_m
  friend bool operator==(const NeighbourMargin&, const NeighbourMargin&) = default;
};

/// Pairs visited in every step, i < j in the sorted order, ascending in (i, j). A pair that does
/// not touch has no tangential force.
struct NearPairs {
  AlignedVector<std::int32_t> listed;  ///< index in the longer list
  AlignedVector<std::int32_t> i, j;
  std::array<AlignedVector<double>, 3> tangential_n;  ///< force of j on i
  AlignedVector<double> stiffness_n_per_m;            ///< k_n
  AlignedVector<double> reach_m;                      ///< r_i + r_j
  AlignedVector<double> half_difference_m;            ///< (r_i − r_j)/2

  std::size_t size() const { return i.size(); }
  friend bool operator==(const NearPairs&, const NearPairs&) = default;
};

/// The neighbour lists and what says how long they are good for.
struct Neighbours {
  std::vector<std::int32_t> listed_i, listed_j;
  NearPairs near;
  std::array<std::vector<std::int32_t>, 6> listed_at_wall, near_wall;  ///< grains, ascending
  std::vector<std::array<double, 3>> sorted_at_m;  ///< where the grains were when sorted
  GrainBox box_when_sorted;
  double travelled_m = 0;  ///< two grains approached by no more since the near ones were chosen
  friend bool operator==(const Neighbours&, const Neighbours&) = default;
};

struct GrainState {
  ContactLaw law;
  double time_step_s = 0;
  NeighbourMargin margin;
  GrainBox box;
  WallState walls;
  AlignedVector<Grain> grains;
  std::vector<std::int32_t> ids;  ///< of each grain of `grains`, its place in the description
  Neighbours neighbours;
  double time_s = 0;
  std::int64_t steps = 0, sorts = 0;

  friend bool operator==(const GrainState&, const GrainState&) = default;
};

/// Spheres at rest in a box, walls at rest, lists made. The margins follow from the smallest
/// radius. time_step_s = 0 takes usual_time_step (critical_time_step.hpp). Throws
/// std::invalid_argument: no grain, a radius not above 0, a centre outside the box, more than 2³⁰
/// grains, a law out of its range.
GrainState make_grain_state(const std::vector<Sphere>& spheres, const GrainBox& box,
                            const ContactLaw& law, double time_step_s = 0);

/// Spheres in the order of the description.
std::vector<Sphere> spheres_of(const GrainState& state);

}  // namespace triax::sim
