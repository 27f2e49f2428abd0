#pragma once
#include <string>
#include <vector>

#include "sim/stability/controllability.hpp"
#include "src/figures/drawing.hpp"
#include "src/figures/subject.hpp"

namespace triax::src {

/// The scan of one state.
struct NamedScan {
  std::string name;                     ///< "η = 0.60"
  std::vector<sim::ControlPoint> scan;  ///< by rising R
  std::vector<double> roots;            ///< R of Eq. (34) or (35), where they are real
};

/// Nova's index over R, a curve a state, with the line 0, below which control is lost, shaded, and
/// the roots as rings on it. No plot without a point.
Drawing control_scan_figure(const std::vector<NamedScan>& scans, const Subject& subject);

}  // namespace triax::src
