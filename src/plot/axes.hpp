// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Axis rectangles of planes whose angles are to be seen as they are, and several of them.
#include <qcustomplot.h>

#include <vector>

namespace triax::src {

/// Widens one of the two ranges about its middle until a unit is as long on both axes. What takes
/// room beside the axes (titles, legend) must be final.
void set_equal_ranges(QCPAxisRect& rect, const QCPRange& x, const QCPRange& y);

/// Neither lines nor numbers nor grid; the coordinates stay.
void hide_axes(QCPAxisRect& rect);

/// Puts a second axis rectangle to the right of the plot's own, in one row of the layout. Before
/// legend_below().
QCPAxisRect& add_axes_beside(QCustomPlot& plot);

/// The plot's own axis rectangle and `count` − 1 others, row by row, `columns` in a row. Before
/// legend_below(). Pre-condition: count and columns above 0.
std::vector<QCPAxisRect*> add_axes_in_rows(QCustomPlot& plot, int count, int columns);

}  // namespace triax::src
