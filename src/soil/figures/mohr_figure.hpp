// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/plot/figure_files.hpp"
#include "src/study/soil/soil.hpp"

namespace triax::src {

/// The circles of a set with their common tangent, σ′ and τ to one scale. Pre-condition:
/// soil.strength.
NamedFigure mohr_figure(const study::Soil& soil);

}  // namespace triax::src
