// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Curves of a test: solid where it was measured, dotted over a step in which nothing was read, open
// where a sensor could not be believed.
#include <cmath>
#include <functional>
#include <vector>

#include "src/plot/shapes.hpp"
#include "src/study/triaxial/line_breaks.hpp"

namespace triax::src {

struct JoinedLine {
  Points points;                   ///< all finite
  std::vector<study::Join> joins;  ///< of each point to the one before

  void add(const QPointF& point, study::Join join) {
    points.push_back(point);
    joins.push_back(join);
  }
};

/// The states of which `point_of` is finite, in order.
template <class PointOf>
JoinedLine joined_line(const std::vector<lab::State>& states, const study::LineBreaks& breaks,
                       const PointOf& point_of) {
  JoinedLine line;
  study::Joiner joiner(breaks);
  for (const lab::State& state : states) {
    const QPointF point = point_of(state);
    if (std::isfinite(point.x()) && std::isfinite(point.y()))
      line.add(point, joiner.join(state));
    else
      joiner.skip(state);
  }
  return line;
}

/// Draws the line, thinned to what the eye can see: `in_pixels` is where a point is drawn, but for
/// an offset; all points if it is empty. With a name it has one entry in the legend.
void draw_joined(QCPAxisRect& rect, const JoinedLine& line, const QPen& pen,
                 const std::function<QPointF(const QPointF&)>& in_pixels,
                 const std::string& name = {});

}  // namespace triax::src
