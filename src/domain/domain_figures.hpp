#pragma once
// The figures of a bifurcation domain, with the numbers behind them.
#include <vector>

#include "src/plot/figure_files.hpp"
#include "src/probe/cones_figure.hpp"
#include "src/study/domain/domain_report.hpp"
#include "src/study/probe/tested_state.hpp"

namespace triax::src {

/// Fans that a figure of cones holds along each axis and can still be read.
inline constexpr int kMostFans = 12;

/// The map of the domain; its numbers are domain_states_csv and domain_json.
Drawing domain_map(const study::ReportedDomain& domain);

/// Cones at some states of an axisymmetric domain, evenly spread, in the p′-q and in the Rendulic
/// plane (Fig. 12), with the measured increments of tests on top. Empty in plane strain.
std::vector<NamedFigure> domain_cones(const study::ReportedDomain& domain,
                                      const std::vector<study::TestedState>& tests);

}  // namespace triax::src
