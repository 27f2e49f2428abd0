// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/study/triaxial/stress_path.hpp"
#include "src/study/triaxial/tests_origin.hpp"

namespace triax::study {

struct CollapsePoint {
  StressPoint stress;     ///< at the onset of collapse
  std::string test;       ///< its name
  std::string programme;  ///< "ICU", "CSD"...; "other" where unknown
  bool simulated = false;
};

/// Where tests collapsed, each file once (read_again.hpp); those without a collapse point have no
/// part in it.
struct CollapsePoints {
  std::vector<CollapsePoint> points;
  /// Slopes of the lines through the origin that fit the points best, η = Σ q p′ / Σ p′²: of those
  /// in compression, then of those in extension; none where there are no points of that kind.
  std::vector<double> instability_lines;
  /// Stress ratios of the limit surfaces of the tests that collapsed, rising; those that print
  /// alike (to a hundredth) are one.
  std::vector<double> limit_stress_ratios;
  TestsOrigin origin;  ///< of the tests with a point
};

CollapsePoints collapse_points(const std::vector<TestResult>& tests);

}  // namespace triax::study
