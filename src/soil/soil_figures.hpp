// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "src/plot/figure_files.hpp"
#include "src/study/soil/soil.hpp"

namespace triax::src {

/// Those for which there is something to draw.
std::vector<NamedFigure> soil_figures(const study::Soil& soil);

}  // namespace triax::src
