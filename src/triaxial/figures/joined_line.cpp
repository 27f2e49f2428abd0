// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/joined_line.hpp"

#include "src/plot/plot_style.hpp"
#include "src/plot/polyline.hpp"

namespace triax::src {

void draw_joined(QCPAxisRect& rect, const JoinedLine& line, const QPen& pen,
                 const std::function<QPointF(const QPointF&)>& in_pixels, const std::string& name) {
  Points solid;
  bool is_named = name.empty();
  const auto draw = [&](const Points& points, const QPen& with) {
    draw_curve(rect, points, with, is_named ? std::string() : name);
    is_named = true;
  };
  const auto end_solid = [&] {
    Points pixels, kept;
    if (!in_pixels) kept = solid;
    for (std::size_t i = 0; in_pixels && i < solid.size(); ++i)
      pixels.push_back(in_pixels(solid[i]));
    for (const auto i : points_to_draw(pixels, kInvisible)) kept.push_back(solid[i]);
    if (kept.size() > 1) draw(kept, pen);
    solid.clear();
  };
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    if (line.joins[i] != study::Join::solid) end_solid();
    if (line.joins[i] == study::Join::dotted && i > 0) {
      QPen dots = pen;
      dots.setStyle(Qt::DotLine);
      dots.setWidthF(1);
      draw({line.points[i - 1], line.points[i]}, dots);
    }
    solid.push_back(line.points[i]);
  }
  end_solid();
}

}  // namespace triax::src
