#pragma once
// The figures of a bifurcation domain, with the numbers behind them.
#include <vector>

#include "src/figures/cones_figure.hpp"
#include "src/figures/figure_files.hpp"
#include "src/report/domain_report.hpp"
#include "src/report/tested_state.hpp"

namespace triax::src {

/// Fans that a figure of cones holds along each axis and can still be read.
inline constexpr int kMostFans = 12;

/// The map of the domain; its numbers are domain_states_csv and domain_json.
Drawing domain_map(const ReportedDomain& domain);

/// Cones at some states of an axisymmetric domain, evenly spread, in the p′-q and in the Rendulic
/// plane (Fig. 12), with the measured increments of tests on top. Empty in plane strain.
std::vector<NamedFigure> domain_cones(const ReportedDomain& domain,
                                      const std::vector<TestedState>& tests);

}  // namespace triax::src
