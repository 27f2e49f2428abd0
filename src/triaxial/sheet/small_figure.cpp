// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/small_figure.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/plot/log_axis.hpp"
#include "src/plot/polyline.hpp"

namespace triax::src {
namespace {

constexpr int kWidth = kSheetFigureWidth, kHeight = kSmallFigureHeight;
// A step that is this part of the figure's diagonal, and so many times as long as the mean of the
// others, is no curve that was read.
constexpr double kLongStep = 0.25, kTimesOthers = 8;

/// Numbers of those points, in pixels, to which the specimen ran away from the point before.
std::vector<std::size_t> ends_of_long_steps(const Points& pixels) {
  std::vector<double> steps;
  double all = 0;
  for (std::size_t i = 1; i < pixels.size(); ++i) {
    const auto way = pixels[i] - pixels[i - 1];
    all += steps.emplace_back(std::hypot(way.x(), way.y()));
  }
  std::vector<std::size_t> ends;
  if (steps.size() < 3) return ends;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (steps[i] > kLongStep * std::hypot(kWidth, kHeight) &&
        steps[i] * static_cast<double>(steps.size() - 1) > kTimesOthers * (all - steps[i]))
      ends.push_back(i + 1);
  return ends;
}

}  // namespace

QCPScatterStyle failure_marker() {
  return {QCPScatterStyle::ssSquare, line(kInk, 1.6), QBrush(Qt::white), 9};
}
QCPScatterStyle onset_ring() {
  return {QCPScatterStyle::ssCircle, line(kVermilion, 1.6), QBrush(Qt::white), 8};
}

SmallFigure::SmallFigure(const std::string& x, const std::string& y)
    : plot_(make_plot(kWidth, kHeight)) {
  style_axes(*plot_->axisRect(), x, y);
  for (auto* axis : plot_->axisRect()->axes()) axis->setLabelFont(label_font());
  for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft})
    plot_->axisRect()->axis(side)->ticker()->setTickCount(5);
  plot_->axisRect()->setMinimumMargins(QMargins(6, 10, 12, 6));
}

void SmallFigure::take_in(const Points& points) {
  for (const auto& p : points) x_.add(p.x()), y_.add(p.y());
}

void SmallFigure::take_in_zero(bool x, bool y) {
  if (x) x_.add(0);
  if (y) y_.add(0);
}

void SmallFigure::fix_ranges() {
  plot_->xAxis->setRange(x_.with_margin(0.04, true));
  plot_->yAxis->setRange(y_.with_margin(0.08, true));
}

void SmallFigure::fix_log_ranges(const Points& points) {
  fix_ranges();
  double low = points.front().x(), high = low;
  for (const auto& p : points) low = std::min(low, p.x()), high = std::max(high, p.x());
  set_log_axis(*plot_->xAxis, low, high);
}

void SmallFigure::curve(const Points& points, const QPen& pen, bool dotted_steps) {
  Points pixels;
  for (const auto& p : points) pixels.push_back(in_pixels(p));
  std::size_t from = 0;
  const auto stretch = [&](std::size_t end) {
    Points kept;
    const Points part(pixels.begin() + static_cast<std::ptrdiff_t>(from),
                      pixels.begin() + static_cast<std::ptrdiff_t>(end));
    for (const auto i : points_to_draw(part, kInvisible)) kept.push_back(points[from + i]);
    if (kept.size() > 1) draw_curve(*plot_->axisRect(), kept, pen);
    from = end;
  };
  const auto ends = dotted_steps ? ends_of_long_steps(pixels) : std::vector<std::size_t>{};
  for (const auto end : ends) {
    stretch(end);
    draw_curve(*plot_->axisRect(), {points[end - 1], points[end]},
               line(pen.color(), 1, Qt::DotLine));
  }
  stretch(points.size());
}

void SmallFigure::marker(const Points& points, const QCPScatterStyle& style) {
  if (!points.empty()) draw_markers(*plot_->axisRect(), points, style);
}

QPointF SmallFigure::in_pixels(const QPointF& p) const {
  const auto part = [](const QCPAxis& axis, double value) {
    const auto range = axis.range();
    return axis.scaleType() == QCPAxis::stLogarithmic
               ? std::log(value / range.lower) / std::log(range.upper / range.lower)
               : value / range.size();
  };
  return {kWidth * part(*plot_->xAxis, p.x()), kHeight * part(*plot_->yAxis, p.y())};
}

}  // namespace triax::src
