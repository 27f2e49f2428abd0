// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/plot/shapes.hpp"

namespace triax::src {

struct LabelledCurve {
  Points points;  ///< in plot coordinates
  QPointF top;    ///< the point of the curve that the label belongs to
  std::string text;
  QColor colour;
};

/// Writes the labels in a column beside the curves, in the order of the heights of their tops and
/// as near to them as labels that do not cover one another and the lower border allow, to the right
/// of every curve that passes at their height, each with a thin line to its top. Ranges of the axes
/// and the size of the plot must be final.
void label_beside(QCPAxisRect& rect, const std::vector<LabelledCurve>& curves);

}  // namespace triax::src
