// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Circles and spokes of a diagram around the directions of a plane.
#include <qcustomplot.h>

#include <string>
#include <vector>

#include "src/plot/shapes.hpp"

namespace triax::src {

struct PolarCircle {
  double radius = 0;
  std::string label;  ///< empty: none
  QPen pen;
  std::string name;  ///< in the legend; empty: none
};

struct PolarFrame {
  double radius = 1;  ///< of the rim
  std::vector<PolarCircle> circles;
  std::string x_name, y_name;  ///< of the axes at 0° and 90°
};

QPointF polar(double radius, double angle);
Points circle_of(double radius);

/// Spokes with their α every 30°, the circles, the names of the two axes. Sets the ranges of the
/// axes, equal and final: what stands beside and below must be in the layout.
void draw_polar_frame(QCPAxisRect& rect, const PolarFrame& frame);

}  // namespace triax::src
