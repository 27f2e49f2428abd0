// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/plot/figure_files.hpp"
#include "src/study/element/path_result.hpp"

namespace triax::src {

/// A path in four planes, those without data left out: q over ε₁, q over p′, ε_v (undrained: u)
/// over ε₁, e over log p′; with its rows as data. No plot where no plane has two points.
NamedFigure path_figure(const study::PathResult& path);

}  // namespace triax::src
