// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/polar_frame.hpp"

#include <fmt/format.h>

#include <QFontMetricsF>
#include <cmath>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/plot/axes.hpp"
#include "src/plot/plot_style.hpp"

namespace triax::src {
namespace {

constexpr double kRoom = 1.18;     // of the rim's radius, for what is written around it
constexpr double kNumbers = 1.03;  // where α is written
constexpr double kLabelAngle =
    75.0;  // degrees; the spoke's neighbourhood holds the circles' labels

}  // namespace

QPointF polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Points circle_of(double radius) {
  Points points;
  for (int degrees = 0; degrees <= 360; degrees += 2)
    points.push_back(polar(radius, sim::radians(degrees)));
  return points;
}

void draw_polar_frame(QCPAxisRect& rect, const PolarFrame& frame) {
  hide_axes(rect);
  const QCPRange range(-kRoom * frame.radius, kRoom * frame.radius);
  set_equal_ranges(rect, range, range);
  for (int degrees = 0; degrees < 360; degrees += 30) {
    const double angle = sim::radians(degrees);
    const bool axis = degrees % 90 == 0;
    draw_curve(rect, {{0, 0}, polar(frame.radius, angle)}, line(axis ? kGrey : kGridLine, 1));
    const QPointF at = polar(kNumbers * frame.radius, angle);
    write_text(rect, at, fmt::format("{}°", degrees), kInk, part_away({0, 0}, at));
  }
  draw_curve(rect, circle_of(frame.radius), line(kInk, 1));
  for (const auto& circle : frame.circles) {
    draw_curve(rect, circle_of(circle.radius), circle.pen, circle.name);
    if (!circle.label.empty())
      write_text(rect, polar(circle.radius, sim::radians(kLabelAngle)), circle.label, kGrey,
                 Qt::AlignHCenter | Qt::AlignBottom);
  }
  // Below the number of its axis, and above that of the other.
  const double text = QFontMetricsF(label_font()).height();
  const double pixel = rect.axis(QCPAxis::atLeft)->range().size() / rect.height();
  const double beyond = kNumbers * frame.radius;
  write_text(rect, {beyond, -0.6 * text * pixel}, frame.x_name, kInk, Qt::AlignLeft | Qt::AlignTop);
  write_text(rect, {0, beyond + 1.1 * text * pixel}, frame.y_name, kInk,
             Qt::AlignHCenter | Qt::AlignBottom);
}

}  // namespace triax::src
