// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/plot/drawing.hpp"
#include "src/study/triaxial/shear_series.hpp"

namespace triax::src {

/// q over the axial strain of several tests: on the left the whole of shear, on the right its
/// beginning, up to some strains at the onset of collapse. No plot without states of shear.
Drawing shear_curves_figure(const study::ShearSeries& series);

}  // namespace triax::src
