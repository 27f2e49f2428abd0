// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/plot/drawing.hpp"
#include "src/study/triaxial/collapse_points.hpp"

namespace triax::src {

/// The collapse points of all tests in the q-p′ plane, with one instability line fitted through
/// them and the Mohr-Coulomb line of each limit that was used. A marker shape per type of test;
/// filled for recorded tests, open for simulated ones. No plot without a collapse point.
Drawing collapse_points_figure(const study::CollapsePoints& found);

}  // namespace triax::src
