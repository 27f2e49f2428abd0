// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/series_plot.hpp"

#include <algorithm>
#include <cmath>

#include "src/plot/plot_style.hpp"
#include "src/plot/polyline.hpp"

namespace triax::src {
namespace {

QPen series_pen(std::size_t number, std::size_t tests) {
  if (tests <= kMostNamed) return curve_pen(number);
  auto colour = kBlue;
  colour.setAlpha(90);
  return line(colour, 1);
}

}  // namespace

QCPScatterStyle onset_marker() {
  return {QCPScatterStyle::ssCircle, line(kVermilion, 1.6), QBrush(Qt::white), 8};
}

void name_series(QCPAxisRect& rect, const std::vector<study::SeriesTest>& tests) {
  if (tests.size() > kMostNamed)
    draw_curve(rect, {}, series_pen(0, tests.size()), std::to_string(tests.size()) + " tests");
  else
    for (std::size_t i = 0; i < tests.size(); ++i)
      draw_curve(rect, {}, curve_pen(i), tests[i].name);
  if (std::any_of(tests.begin(), tests.end(),
                  [](const auto& test) { return test.onset.has_value(); }))
    draw_markers(rect, {}, onset_marker(), "onset of collapse");
}

Points points_of(const std::vector<lab::State>& states, StateValue x, StateValue y, double x_most) {
  Points points;
  for (const auto& state : states) {
    const QPointF point(x(state), y(state));
    if (!std::isfinite(point.x()) || !std::isfinite(point.y())) continue;
    if (point.x() > x_most) break;
    points.push_back(point);
  }
  return points;
}

void draw_series(QCPAxisRect& rect, const Points& points, std::size_t number, std::size_t tests) {
  const double across = rect.width() / rect.axis(QCPAxis::atBottom)->range().size();
  const double up = rect.height() / rect.axis(QCPAxis::atLeft)->range().size();
  auto pixels = points;
  for (auto& point : pixels) point = {point.x() * across, point.y() * up};
  Points kept;
  for (const auto i : points_to_draw(pixels, kInvisible)) kept.push_back(points[i]);
  draw_curve(rect, kept, series_pen(number, tests));
}

std::string names_of(const std::vector<study::SeriesTest>& tests) {
  constexpr std::size_t kSome = 3;
  const bool many = tests.size() > kMostNamed;
  const std::size_t told = many ? kSome : tests.size();
  std::string names;
  for (std::size_t i = 0; i < told; ++i)
    names += (i == 0 ? "" : i + 1 == tests.size() ? " and " : ", ") + tests[i].name;
  if (many) names += " and " + std::to_string(tests.size() - kSome) + " others";
  return names;
}

}  // namespace triax::src
