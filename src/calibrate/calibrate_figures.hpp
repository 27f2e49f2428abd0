// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measured curves (points) beside those of the calibrated law (lines), and the domain that it
// implies.
#include <vector>

#include "src/plot/figure_files.hpp"
#include "src/study/calibrate/calibration.hpp"

namespace triax::src {

/// "undrained": q over ε₁ and over p′; "drained": q and ε_v over ε₁; "stress_path": ε₁ and ε_v over
/// p′. Only those of which there are tests. "domain": what the set implies of stability, where it
/// has a domain (implied_domain_figure.hpp).
std::vector<NamedFigure> calibrate_figures(const study::Calibration& calibration);

}  // namespace triax::src
