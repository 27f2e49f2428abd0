#pragma once
// The figures of a report of probes, with the numbers behind them.
#include <string>
#include <vector>

#include "src/plot/drawing.hpp"
#include "src/plot/figure_files.hpp"
#include "src/probe/probe_report.hpp"

namespace triax::src {

/// Circular and polar diagram, work over α, control over R, the response envelope of the last
/// state, and the cones at their states with the tests' own increments (axisymmetric stress probes
/// only). Of many states a few are drawn in one diagram, with the data of those; cones are left out
/// where they would lie on each other, their data are those of all. Where the report's directions
/// are more than 2° apart, diagrams around a state are drawn, and their data written, every 1°.
/// Without an answered direction there is none.
std::vector<NamedFigure> probe_figures(const ProbeReport& report);

/// Every direction of every state.
FigureData probes_data(const ProbeReport& report);
/// Every cone of every state; a state without one is a row with nothing in it.
FigureData cones_data(const ProbeReport& report);

}  // namespace triax::src
