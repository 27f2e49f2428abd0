// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Several tests in one plane.
#include <vector>

#include "src/plot/drawing.hpp"
#include "src/triaxial/sheet/sheet_axes.hpp"

namespace triax::src {

/// Shear of several tests in one plane; of more than kMostCurves a band that holds nine of ten and
/// the median, at steps of x. Nothing without a point.
OwnPlot set_figure(const std::vector<const SheetTest*>& tests, const SheetAxis& x,
                   const SheetAxis& y);
/// Their consolidation over √t, of those whose water was measured; nothing where none was.
OwnPlot set_consolidation_figure(const std::vector<const SheetTest*>& tests);
inline constexpr std::size_t kMostCurves = 24;
/// Numbers of those of many curves or circles that are drawn in one plane: all of sixty, else about
/// sixty, in no step with the values of a sweep.
std::vector<std::size_t> drawn_of_many(std::size_t count);

}  // namespace triax::src
