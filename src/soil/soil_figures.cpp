// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/soil/soil_figures.hpp"

namespace triax::src {

std::vector<NamedFigure> soil_figures(const study::Soil&) { return {}; }

}  // namespace triax::src
