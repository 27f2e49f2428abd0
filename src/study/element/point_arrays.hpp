// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Many points of one law, taken one increment further each: what a host program does at its
// integration points, as arrays that such a program holds.
//
// Row i of every array is point i. Components are those of the tensor itself, axial, radial or 11,
// 22, 33, 12, 13, 23; stress is effective, in kPa. Memory is the law's own (Law::memory_names).
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "sim/point/point_driver.hpp"

namespace triax::study {

struct PointArrays {
  std::size_t count = 0, components = 0, memories = 0;
  std::vector<double> stress_kPa;  ///< count × components
  std::vector<double> void_ratio;  ///< count
  std::vector<double> memory;      ///< count × memories
};

/// As Law::start has them, without memory of shear. `stress_kPa` is count × components,
/// `void_ratio` has a value a point.
template <class Space>
PointArrays start_points(const sim::Law<Space>& law, std::vector<double> stress_kPa,
                         std::vector<double> void_ratio);

/// Conditions S dσ′ + E dε = dy in kPa and components of the tensor; `rows` is count × components
/// or one row for all points.
template <class Space>
struct PointConditions {
  sim::Matrix<Space> stress = sim::Matrix<Space>::Zero();  ///< S
  sim::Matrix<Space> strain = sim::Matrix<Space>::Zero();  ///< E
  std::vector<double> rows;                                ///< dy
};

/// What became of each point.
struct StepArrays {
  std::vector<std::uint8_t> outcome;  ///< sim::StepOutcome
  std::vector<double> done;           ///< fraction of the increment
  std::vector<double> error;          ///< estimated, relative, as PointStep::error
  std::vector<double> stress_kPa;     ///< dσ′ of the part done, count × components
  std::vector<double> strain;         ///< dε of the part done, count × components
  std::vector<double> work_kPa;       ///< dσ′:dε of the part done
  std::vector<double>
      work_normalised;         ///< over the norms of both, in [−1, 1]; 0 where one vanishes
  std::size_t stopped_at = 0;  ///< points from here on were not taken further; count: none
  /// Of the first hundred that were not accepted: their place and why.
  std::vector<std::pair<std::size_t, std::string>> messages;
};

/// Takes each point along its increment; a point ends where what could be done of it ends. Results
/// of a point do not depend on the others. `stop` is asked every thousand points. Pre-condition:
/// the arrays have the sizes that are said above.
template <class Space>
StepArrays advance_points(const sim::Law<Space>& law, const PointConditions<Space>& conditions,
                          const sim::PointTolerance& tolerance, PointArrays& points,
                          const std::function<bool()>& stop = {});

// clang-format off
extern template PointArrays start_points(const sim::Law<sim::Axisymmetric>&, std::vector<double>, std::vector<double>);
extern template PointArrays start_points(const sim::Law<sim::Tensor>&, std::vector<double>, std::vector<double>);
extern template StepArrays advance_points(const sim::Law<sim::Axisymmetric>&, const PointConditions<sim::Axisymmetric>&,
                                          const sim::PointTolerance&, PointArrays&, const std::function<bool()>&);
extern template StepArrays advance_points(const sim::Law<sim::Tensor>&, const PointConditions<sim::Tensor>&,
                                          const sim::PointTolerance&, PointArrays&, const std::function<bool()>&);
// clang-format on

}  // namespace triax::study
