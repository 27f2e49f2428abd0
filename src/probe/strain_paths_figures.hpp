// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The figure of proportional strain paths, with the numbers behind it.
#include "src/plot/figure_files.hpp"
#include "src/study/probe/strain_paths.hpp"

namespace triax::src {

/// Every point of every path.
FigureData strain_paths_data(const study::StrainPathsResult& result);
Drawing strain_paths_drawing(const study::StrainPathsResult& result);

}  // namespace triax::src
