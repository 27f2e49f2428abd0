// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lab/results/summary.hpp"
#include "src/study/triaxial/line_breaks.hpp"
#include "src/study/triaxial/tests_origin.hpp"

namespace triax::study {

struct StressPoint {
  double p_pa = 0, q_pa = 0;  ///< p′ and q

  double eta() const { return q_pa / p_pa; }
};

/// The effective stress of this instant; nothing unless its stress ratio is known.
std::optional<StressPoint> stress_at(const std::optional<lab::Instant>& instant);

/// The effective stress path of one test, each part in order.
struct StressPath {
  std::string test;                ///< its name
  std::vector<lab::State> before;  ///< in stages that are said not to be shear
  std::vector<lab::State> shear;
  LineBreaks breaks{};               ///< of lines through them
  std::optional<StressPoint> onset;  ///< of collapse
  std::optional<StressPoint> loss_of_control;
  std::optional<StressPoint> failure;        ///< which is no collapse
  std::optional<StressPoint> true_onset;     ///< of a simulated specimen itself
  std::optional<double> limit_stress_ratio;  ///< M of the limit surface
  std::optional<double> limit_intercept_pa;  ///< k of it, with cohesion
  TestsOrigin origin;
};

/// From the curves of the test: without them a path without points.
StressPath stress_path(const TestResult& test);

}  // namespace triax::study
