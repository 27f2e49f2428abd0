// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tests that do not belong to the others of a fit.
#include <cstddef>
#include <string>
#include <vector>

#include "src/study/soil/line_fit.hpp"

namespace triax::study {

struct OddTest {
  std::size_t index = 0;  ///< among the points
  double residual = 0;    ///< from what the others give, in the unit of y
  double deviations = 0;  ///< residual in standard deviations
};

enum class FitKind { mean, line };

/// The points that lie so far from the fit through the others that chance does it in less than one
/// fit of a hundred (Student's t of the deleted residual, divided among the points); the worst is
/// taken out, then the rest is asked again, no more than a third of them in all. The variance is
/// that of the others together with `usual`, the standard deviation that repeated tests of a good
/// laboratory have, which counts as four tests: three tests that happen to lie on one line
/// condemn no fourth.
std::vector<OddTest> odd_tests(std::vector<FitPoint> points, FitKind kind, double usual);

}  // namespace triax::study
