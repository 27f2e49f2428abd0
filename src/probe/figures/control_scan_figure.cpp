// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/figures/control_scan_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "src/plot/plot_style.hpp"
#include "src/plot/point_labels.hpp"
#include "src/plot/shapes.hpp"

namespace triax::src {
namespace {

constexpr int kControlScanWidth = 680, kControlScanHeight = 460 + kOriginHeight;

QCPScatterStyle limit_marker(const QColor& colour) {
  return {QCPScatterStyle::ssCircle, line(colour, 1.8), QBrush(Qt::white), 9};
}

/// The index where there is control, to 0 at its limits if they are on the axis, with a gap where
/// it is lost.
Points curve_of(const NamedScan& scan, const QCPRange& axis) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  Points points;
  auto lost = scan.lost.begin();
  const auto pass = [&](const sim::LostControl& range) {
    if (range.begins && axis.contains(range.from)) points.emplace_back(range.from, 0);
    points.emplace_back(range.from, kGap);
    if (range.ends && axis.contains(range.to)) points.emplace_back(range.to, 0);
  };
  for (const auto& point : scan.scan) {
    while (lost != scan.lost.end() && lost->to < point.R) pass(*lost++);
    if (lost != scan.lost.end() && lost->from <= point.R) continue;
    const std::optional<double> index = point.index;
    points.emplace_back(point.R, index && std::isfinite(*index) ? *index : kGap);
  }
  while (lost != scan.lost.end()) pass(*lost++);
  return points;
}

/// Over the whole height, so that bands of several states show where they overlap.
void shade_lost(QCPAxisRect& rect, const NamedScan& scan, const QColor& colour) {
  const auto x = rect.axis(QCPAxis::atBottom)->range(), y = rect.axis(QCPAxis::atLeft)->range();
  QColor fill = colour;
  fill.setAlpha(32);
  for (const auto& range : scan.lost) {
    const double from = std::max(range.from, x.lower), to = std::min(range.to, x.upper);
    if (from >= to) continue;
    auto* area = draw_area(rect, {{from, y.lower}, {to, y.lower}, {to, y.upper}, {from, y.upper}},
                           fill, Qt::NoPen);
    lay_behind(*area);
  }
}

std::string limits_in_words(const std::vector<NamedScan>& scans) {
  std::string words;
  for (const auto& scan : scans) {
    const auto limits = scan.limits();
    if (limits.empty()) continue;
    words += (words.empty() ? "" : "; ") + scan.name + (scan.name.empty() ? "R = " : ": R = ");
    for (std::size_t i = 0; i < limits.size(); ++i)
      words += fmt::format("{}{:.4g}", i > 0 ? " and " : "", limits[i]);
  }
  return words;
}

/// Entries for all states together.
void name_limits(QCPAxisRect& rect, const std::vector<NamedScan>& scans) {
  const bool any_limit =
      std::ranges::any_of(scans, [](const auto& scan) { return !scan.limits().empty(); });
  const bool any_lost =
      std::ranges::any_of(scans, [](const auto& scan) { return !scan.lost.empty(); });
  if (any_limit) draw_markers(rect, {}, limit_marker(kInk), "limit of control");
  if (any_lost) draw_area(rect, {}, QColor(0xDD, 0xDD, 0xDD), Qt::NoPen, "control lost");
}

}  // namespace

std::vector<double> NamedScan::limits() const {
  std::vector<double> limits;
  for (const auto& range : lost) {
    if (range.begins) limits.push_back(range.from);
    if (range.ends) limits.push_back(range.to);
  }
  return limits;
}

Drawing control_scan_figure(const std::vector<NamedScan>& scans, const Subject& subject) {
  const bool axisymmetric = subject.plane == sim::ProbePlane::axisymmetric;
  RangeOf x, y;
  for (const auto& scan : scans)
    for (const auto& point : scan.scan) x.add(point.R);
  if (x.empty()) return {};
  const QCPRange axis = x.with_margin(0.02, false);
  for (const auto& scan : scans)
    for (const auto& point : curve_of(scan, axis)) y.add(point.y());
  y.add(0);
  auto plot = make_plot(kControlScanWidth, kControlScanHeight);
  auto& rect = *plot->axisRect();
  style_axes(rect, axisymmetric ? "R, of dε₁ + 2R dε₃ = 0 (–)" : "R, of dε₁ + R dε₃ = 0 (–)",
             "index of control (–)");
  plot->xAxis->setRange(axis);
  plot->yAxis->setRange(y.with_margin(0.08, false));
  draw_curve(rect, {{axis.lower, 0}, {axis.upper, 0}}, line(kInk, 1));
  std::vector<PointLabel> labels;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const QColor colour = curve_pen(i).color();
    draw_curve(rect, curve_of(scans[i], axis), curve_pen(i), scans[i].name);
    shade_lost(rect, scans[i], colour);
    Points limits;
    for (const double limit : scans[i].limits()) {
      if (!axis.contains(limit)) continue;
      limits.emplace_back(limit, 0);
      labels.push_back({limit, 0, fmt::format("{:.3f}", limit), colour});
    }
    if (!limits.empty()) draw_markers(rect, limits, limit_marker(colour));
  }
  name_limits(rect, scans);
  legend_below(*plot, 3);
  origin_below(*plot, subject);
  place_labels(*plot, labels);
  const auto limits = limits_in_words(scans);
  return {std::move(plot),
          fmt::format("Index of control of (dσ₁′ − dσ₃′/R, dε₁ + {}R dε₃) over R; control is lost "
                      "in the shaded ranges{}. {}",
                      axisymmetric ? "2" : "", limits.empty() ? "" : " (limits " + limits + ")",
                      simulated_with(subject))};
}

}  // namespace triax::src
