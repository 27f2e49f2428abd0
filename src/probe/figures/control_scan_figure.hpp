// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "sim/stability/controllability.hpp"
#include "src/plot/drawing.hpp"
#include "src/plot/subject.hpp"

namespace triax::src {

/// The scan of one state.
struct NamedScan {
  std::string name;                     ///< "η = 0.60"
  std::vector<sim::ControlPoint> scan;  ///< by rising R
  std::vector<sim::LostControl> lost;   ///< ranges of R without control, rising, apart

  /// R at which control is lost or found again.
  std::vector<double> limits() const;
};

/// Nova's index over R, a curve a state. It runs to 0 at the limits of control, which are rings,
/// and has a gap where control is lost: there is a band in the colour of the state. No plot without
/// a point.
Drawing control_scan_figure(const std::vector<NamedScan>& scans, const Subject& subject);

}  // namespace triax::src
