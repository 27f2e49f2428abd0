// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Names beside points without covering one another.
#include <qcustomplot.h>

#include <string>
#include <vector>

namespace triax::src {

struct PointLabel {
  double x = 0;  ///< plot coordinates
  double y = 0;
  std::string text;
  QColor colour;
};

/// Writes each text beside its point on the side where it covers no marker, no other label and does
/// not leave the axes; among such places the one that lies on the least of the plot's lines,
/// somewhat farther off, with a thin line to the point, where all are crowded or there is none. A
/// text for which there is no such place is left out. Ranges of the axes, what is drawn and the
/// size of the plot must be final.
void place_labels(QCustomPlot& plot, const std::vector<PointLabel>& labels);
/// The same in one axis rectangle of several. Words that stand there already are kept free.
void place_labels(QCPAxisRect& rect, const std::vector<PointLabel>& labels);

}  // namespace triax::src
