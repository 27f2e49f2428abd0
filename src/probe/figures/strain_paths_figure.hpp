// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "sim/stability/strain_paths.hpp"
#include "src/plot/drawing.hpp"
#include "src/plot/subject.hpp"

namespace triax::src {

/// Proportional strain paths dε₁ + 2R dε₃ = 0 (Fig. 16 of the paper): on the left q over p′, on the
/// right σ₁′ − σ₃′/R over ε₁, with the peak of σ₁′ − σ₃′/R as a circle and W₂ = 0 as a cross. R is
/// in the legend and, on the right, in a column beside the curves with a line to each peak (of a
/// curve without one: to its highest point). No plot without a point.
Drawing strain_paths_figure(const std::vector<sim::StrainPath>& paths, const Subject& subject);

}  // namespace triax::src
