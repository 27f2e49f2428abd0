// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The figures of probes, with the numbers behind them.
#include <vector>

#include "src/plot/figure_files.hpp"
#include "src/study/probe/probe_result.hpp"

namespace triax::src {

/// Circular and polar diagram, work over α, control over R, the response envelope of the last state
/// drawn, and the cones at their states with the tests' own increments (axisymmetric stress probes
/// only), of the states and circles in `result.figures`, with the data of those; the data of the
/// cones are of all states. None without a circle to draw.
std::vector<NamedFigure> probe_figures(const study::ProbeResult& result);

}  // namespace triax::src
