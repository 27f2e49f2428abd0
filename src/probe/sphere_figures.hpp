// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The figure of probes in all directions of space, with the numbers behind it.
#include "src/plot/figure_files.hpp"
#include "src/study/probe/sphere.hpp"

namespace triax::src {

/// Every direction of every state.
FigureData sphere_data(const study::SphereResult& result);
/// Of the last state.
Drawing sphere_drawing(const study::SphereResult& result);

}  // namespace triax::src
