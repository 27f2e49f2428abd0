// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/plot/drawing.hpp"
#include "src/study/triaxial/shear_series.hpp"

namespace triax::src {

/// Effective stress paths of shear of several tests in the q-p′ plane, with the onset of each
/// collapse, the instability line that fits these tests best and the Mohr-Coulomb lines of their
/// limits. No plot without states of shear.
Drawing stress_paths_figure(const study::ShearSeries& series);

}  // namespace triax::src
