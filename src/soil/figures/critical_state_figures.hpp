// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/plot/figure_files.hpp"
#include "src/study/soil/soil.hpp"

namespace triax::src {

/// e over p′ (logarithmic) with the paths of the tests, their critical states and the line in both
/// forms. Pre-condition: soil.critical_line.
NamedFigure critical_line_figure(const study::Soil& soil);
/// q over p′ with the paths, the critical states and M. Pre-condition: soil.critical_ratio or
/// soil.extension_ratio.
NamedFigure critical_ratio_figure(const study::Soil& soil);

}  // namespace triax::src
