// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The domain and the cones that a calibrated set implies, in the p′-q plane beside the tests.
#include "src/plot/figure_files.hpp"
#include "src/study/calibrate/calibration.hpp"

namespace triax::src {

/// "domain": paths of the tests with their onsets, first unstable states and plastic limit as
/// lines with the band of the draws, cones as fans: dark where nearly all draws agree, light as far
/// as their edges scatter. One unit of stress is as long on both axes. Pre-condition: the
/// calibration has a domain, and it is not `none`.
NamedFigure implied_domain_figure(const study::Calibration& calibration);

}  // namespace triax::src
