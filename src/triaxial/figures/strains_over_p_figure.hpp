// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/plot/drawing.hpp"
#include "src/study/triaxial/shear_series.hpp"

namespace triax::src {

/// Axial strain (left) and volumetric strain (right) over p′ of several tests, up to some strains
/// at the onset of collapse: what a specimen does while p′ is lowered at constant q. No plot
/// without states of shear.
Drawing strains_over_p_figure(const study::ShearBeginnings& beginnings);

}  // namespace triax::src
