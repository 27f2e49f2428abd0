// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Panels over each other along one axis, and lines through all of them.
#include <qcustomplot.h>

#include <string>
#include <vector>

#include "src/study/triaxial/history_axis.hpp"

namespace triax::src {

inline constexpr int kHistoryWidth = 620;
inline constexpr int kPanelHeight = 150;
inline constexpr int kAxisHeight = 50;

/// One more panel below those that are there.
QCPAxisRect* add_panel(QCustomPlot& plot, QCPMarginGroup* margins, const std::string& title);
QCPGraph* add_graph(QCPAxisRect& rect, const QPen& pen);

/// A line through all panels, with its name above them.
struct Mark {
  double position;  ///< on the common axis, in its unit
  std::string name;
  QPen pen;
};
/// What their names need above the top panel.
int height_of_names(const std::vector<Mark>& marks);
/// Ranges of the axes must be final.
void draw_marks(QCustomPlot& plot, const std::vector<Mark>& marks);

/// One common axis below; rows are as high as what stands above or below their axes, so that panels
/// come out as high as `heights` says (kPanelHeight where it says nothing).
void finish_rows(QCustomPlot& plot, const study::HistoryAxis& axis, const std::vector<int>& heights,
                 int names_height);

}  // namespace triax::src
