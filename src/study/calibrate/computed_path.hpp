// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A law driven through a measured path.
#include <optional>
#include <string>
#include <vector>

#include "sim/law/law.hpp"
#include "src/study/calibrate/measured_path.hpp"

namespace triax::study {

struct ComputedPath {
  /// What the law gives at the knots of the measured path, as many of them as it reached.
  std::vector<PathKnot> knots;
  /// Knots reached, and the share of the way to the next: the number of knots where all were.
  double reached = 0;
  /// The state where it stopped short of a knot.
  PathKnot last;
  std::string refusal;  ///< why it did; empty where it reached all
};

struct DrivingOptions {
  double tolerance = 1e-6;  ///< relative error of an integration step
  int step_limit = 2000;    ///< of integration steps between two knots
};

/// Imposes at each knot what was measured there. Whatever the law refuses is in the result.
ComputedPath drive(const sim::Law<sim::Axisymmetric>& law, const MeasuredPath& path,
                   const DrivingOptions& options = {});

/// q/p′ where the second-order work of the law along the path first becomes negative, isolated
/// within the step, or where the imposed stress cannot be held; empty where neither happens, and
/// where a plug-in fails before.
std::optional<double> onset_eta(const sim::Law<sim::Axisymmetric>& law, const MeasuredPath& path,
                                const DrivingOptions& options = {});

}  // namespace triax::study
