// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The tables of probes: every direction, every cone, every R.
#include "src/plot/figure_files.hpp"
#include "src/study/probe/probe_result.hpp"

namespace triax::src {

/// Every direction of every state.
FigureData probes_data(const study::ProbeResult& result);
/// Every cone of every state; a state without one is a row with nothing in it.
FigureData cones_data(const study::ProbeResult& result);

/// What figures are drawn from: every direction of these circles, and every R of all states drawn.
FigureData drawn_probes_data(const study::ProbeResult& result,
                             const std::vector<study::DrawnCircle>& circles);
FigureData drawn_control_data(const study::ProbeResult& result);

}  // namespace triax::src
