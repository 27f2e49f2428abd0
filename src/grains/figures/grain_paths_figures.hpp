// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Paths of a specimen of grains. Stresses are those on the walls; there is no pore water.
#include <vector>

#include "src/plot/drawing.hpp"
#include "src/plot/subject.hpp"
#include "src/study/grains/grain_curves.hpp"

namespace triax::src {

/// Fig. 16: left q over p, right σ₁ − σ₃/R over ε₁, a colour a path with its label in the legend
/// and beside its curve on the right; peaks as circles, the onset of W₂ < 0 as crosses, marks as
/// diamonds with their names. No plot without a point.
Drawing grain_strain_paths_figure(const std::vector<study::GrainCurve>& all,
                                  const Subject& subject);

/// Left q, right ε_v over ε₁. No plot without a point.
Drawing grain_shear_figure(const std::vector<study::GrainCurve>& all, const Subject& subject);
/// Left p, right porosity over ε_v: isotropic paths, where ε₁ is a third of that.
Drawing grain_compression_figure(const std::vector<study::GrainCurve>& all, const Subject& subject);

}  // namespace triax::src
