// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/series_plot.hpp"

#include <algorithm>
#include <cmath>

#include "src/plot/plot_style.hpp"

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

QCPScatterStyle loss_of_control_marker() {
  return {QCPScatterStyle::ssDiamond, line(kPurple, 1.6), QBrush(Qt::white), 9};
}

void name_series(QCPAxisRect& rect, const std::vector<study::SeriesTest>& tests) {
  if (tests.size() > kMostNamed)
    draw_curve(rect, {}, series_pen(0, tests.size()), std::to_string(tests.size()) + " tests");
  else
    for (std::size_t i = 0; i < tests.size(); ++i)
      draw_curve(rect, {}, curve_pen(i), tests[i].name);
  if (std::ranges::any_of(tests, [](const auto& test) { return test.onset.has_value(); }))
    draw_markers(rect, {}, onset_marker(), "onset of instability");
  if (std::ranges::any_of(tests, [](const auto& test) { return test.loss_of_control.has_value(); }))
    draw_markers(rect, {}, loss_of_control_marker(), "loss of control");
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

JoinedLine line_of(const study::SeriesTest& test, StateValue x, StateValue y, double x_most) {
  const auto end = std::ranges::find_if(test.states, [&](const lab::State& state) {
    return x(state) > x_most && std::isfinite(y(state));
  });
  return joined_line({test.states.begin(), end}, test.breaks,
                     [&](const lab::State& state) { return QPointF(x(state), y(state)); });
}

void draw_series(QCPAxisRect& rect, const JoinedLine& line, std::size_t number, std::size_t tests) {
  const double across = rect.width() / rect.axis(QCPAxis::atBottom)->range().size();
  const double up = rect.height() / rect.axis(QCPAxis::atLeft)->range().size();
  draw_joined(rect, line, series_pen(number, tests),
              [&](const QPointF& point) { return QPointF(point.x() * across, point.y() * up); });
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
