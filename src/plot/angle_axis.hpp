// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Values over the direction α of an increment, from 0° to 360°.
#include <string>

#include "src/plot/shapes.hpp"
#include "src/plot/subject.hpp"

namespace triax::src {

/// The axes in the house style: α of increments of that kind and plane below, a number every
/// `step_deg`.
void style_angle_axes(QCPAxisRect& rect, sim::ProbePlane plane, sim::ProbeKind kind,
                      const std::string& y_title, double step_deg = 30);

/// Shades directions from `from_deg` to `to_deg`, in two pieces where they pass 0° or 360°. The
/// range of the left axis must be final. Without a name it has no entry in the legend.
void shade_directions(QCPAxisRect& rect, double from_deg, double to_deg, const QColor& colour,
                      const std::string& name = {});

inline constexpr double kTurnDeg = 360;

}  // namespace triax::src
