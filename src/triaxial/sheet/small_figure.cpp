// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/small_figure.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/plot/log_axis.hpp"

namespace triax::src {
namespace {

constexpr int kWidth = kSheetFigureWidth, kHeight = kSmallFigureHeight;
}  // namespace

QCPScatterStyle failure_marker() {
  return {QCPScatterStyle::ssSquare, line(kInk, 1.6), QBrush(Qt::white), 9};
}
QCPScatterStyle onset_ring() {
  return {QCPScatterStyle::ssCircle, line(kVermilion, 1.6), QBrush(Qt::white), 8};
}
QCPScatterStyle loss_of_control_diamond() {
  return {QCPScatterStyle::ssDiamond, line(kPurple, 1.6), QBrush(Qt::white), 9};
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

void SmallFigure::curve(const JoinedLine& line, const QPen& pen) {
  draw_joined(*plot_->axisRect(), line, pen,
              [this](const QPointF& point) { return in_pixels(point); });
}

void SmallFigure::curve(const Points& points, const QPen& pen) {
  curve(JoinedLine{points, std::vector<study::Join>(points.size())}, pen);
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
