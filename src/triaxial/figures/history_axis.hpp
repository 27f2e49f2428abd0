#pragma once
// The common horizontal axis of the histories of one test.
#include <optional>
#include <string>

#include "src/triaxial/figures/history_figure.hpp"

namespace triax::src {

struct HistoryAxis {
  bool along_time = true;
  double unit = 1;    ///< SI value of one unit of the axis
  double origin = 0;  ///< SI value at 0 of the axis: where the span begins for a time axis
  double begin = 0;   ///< SI
  double end = 0;     ///< SI
  std::string title;  ///< "time since start of shear (s)", "axial strain ε₁ (%)"

  /// Nothing for a value outside the span or unknown.
  std::optional<double> position(double time_s, double axial_strain) const;
};

/// Nothing where the test has no state in the span.
std::optional<HistoryAxis> history_axis(const study::TestResult& test, Span span);

}  // namespace triax::src
