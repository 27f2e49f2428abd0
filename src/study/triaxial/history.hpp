// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a test went through along one common axis: its quantities, its second-order work, and where
// along the axis it became unstable.
#include <optional>
#include <string>
#include <vector>

#include "src/study/triaxial/history_axis.hpp"
#include "src/study/triaxial/line_breaks.hpp"
#include "src/study/triaxial/tests_origin.hpp"

namespace triax::study {

enum class HistoryQuantity { q, pore_pressure, volumetric_strain, axial_strain };

struct HistoryPoint {
  double at = 0;     ///< along the axis, in its units
  double value = 0;  ///< SI
  Join join = Join::solid;
};

struct HistoryCurve {
  HistoryQuantity quantity = HistoryQuantity::q;
  std::vector<HistoryPoint> points;  ///< those known within the span, in order
  double smallest = 0, largest = 0;  ///< in the whole test, SI
};

struct HistoryWork {
  double at = 0;          ///< along the axis, in its units
  double normalised = 0;  ///< second-order work, between −1 and 1; NaN: a gap
  double error = 0;       ///< one standard error; 0 where not known
};

enum class HistoryMarkKind { onset, loss_of_control, failure, true_onset };

struct HistoryMark {
  double at = 0;  ///< along the axis, in its units
  HistoryMarkKind kind = HistoryMarkKind::onset;
};

struct History {
  std::string test;  ///< its name
  Span span = Span::shear;
  HistoryAxis axis;
  /// q, pore pressure (volumetric strain where none was measured) and axial strain: those that
  /// were measured at all.
  std::vector<HistoryCurve> curves;
  /// Within the span; nothing where the test has no second-order work at all.
  std::optional<std::vector<HistoryWork>> work;
  std::vector<HistoryMark> marks;  ///< those within the span
  TestsOrigin origin;
};

/// From the curves of the test; nothing where the span holds no state or nothing was measured.
std::optional<History> history(const TestResult& test, Span span);

}  // namespace triax::study
