// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The figures of a bifurcation domain, with the numbers behind them.
#include <vector>

#include "src/plot/figure_files.hpp"
#include "src/probe/figures/cones_figure.hpp"
#include "src/study/domain/domain_report.hpp"

namespace triax::src {

/// The map of the domain; its numbers are domain_states_csv and domain_json.
Drawing domain_map(const study::ReportedDomain& domain);

/// Cones of an axisymmetric domain in the p′-q and in the Rendulic plane (Fig. 12); `picture` is
/// what study::cones_picture makes of it.
std::vector<NamedFigure> domain_cones(const study::ReportedDomain& domain,
                                      const study::ConesPicture& picture);

}  // namespace triax::src
