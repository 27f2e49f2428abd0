#include "src/figures/control_scan_figure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/figures/plot_style.hpp"
#include "src/figures/point_labels.hpp"
#include "src/figures/shapes.hpp"

namespace triax::src {
namespace {

constexpr int kWidth = 680, kHeight = 460;

QCPScatterStyle root_marker(std::size_t state) {
  return {QCPScatterStyle::ssCircle, line(curve_pen(state).color(), 1.8), QBrush(Qt::white), 9};
}

void shade_lost(QCPAxisRect& rect) {
  const auto x = rect.axis(QCPAxis::atBottom)->range(), y = rect.axis(QCPAxis::atLeft)->range();
  if (y.lower >= 0) return;
  QColor fill = kVermilion;
  fill.setAlpha(35);
  auto* area = draw_area(rect, {{x.lower, 0}, {x.upper, 0}, {x.upper, y.lower}, {x.lower, y.lower}},
                         fill, Qt::NoPen, "control lost (index < 0)");
  lay_behind(*area);
}

std::string roots_in_words(const std::vector<NamedScan>& scans) {
  std::string words;
  for (const auto& scan : scans) {
    if (scan.roots.empty()) continue;
    words += (words.empty() ? "" : "; ") + scan.name + (scan.name.empty() ? "R = " : ": R = ");
    for (std::size_t i = 0; i < scan.roots.size(); ++i)
      words += fmt::format("{}{:.4g}", i > 0 ? " and " : "", scan.roots[i]);
  }
  return words;
}

}  // namespace

Drawing control_scan_figure(const std::vector<NamedScan>& scans, const Subject& subject) {
  const bool axisymmetric = subject.plane == sim::ProbePlane::axisymmetric;
  RangeOf x, y;
  for (const auto& scan : scans)
    for (const auto& point : scan.scan) {
      x.add(point.R);
      if (point.index) y.add(*point.index);
    }
  if (x.empty()) return {};
  y.add(0);
  auto plot = make_plot(kWidth, kHeight);
  auto& rect = *plot->axisRect();
  style_axes(rect, axisymmetric ? "R, of dε₁ + 2R dε₃ = 0 (–)" : "R, of dε₁ + R dε₃ = 0 (–)",
             "index of control (–)");
  plot->xAxis->setRange(x.with_margin(0.02, false));
  plot->yAxis->setRange(y.with_margin(0.08, false));
  draw_curve(rect, {{plot->xAxis->range().lower, 0}, {plot->xAxis->range().upper, 0}},
             line(kInk, 1));
  std::vector<PointLabel> labels;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    Points points, roots;
    for (const auto& point : scans[i].scan)
      if (point.index) points.emplace_back(point.R, *point.index);
    draw_curve(rect, points, curve_pen(i), scans[i].name);
    for (const double root : scans[i].roots) {
      if (!plot->xAxis->range().contains(root)) continue;
      roots.emplace_back(root, 0);
      labels.push_back({root, 0, fmt::format("{:.3f}", root), curve_pen(i).color()});
    }
    if (!roots.empty()) draw_markers(rect, roots, root_marker(i));
  }
  if (!labels.empty())
    draw_markers(rect, {}, {QCPScatterStyle::ssCircle, line(kInk, 1.8), QBrush(Qt::white), 9},
                 axisymmetric ? "roots of Eq. (34)" : "roots of Eq. (35)");
  shade_lost(rect);
  legend_below(*plot, 3);
  place_labels(*plot, labels);
  const auto roots = roots_in_words(scans);
  return {std::move(plot),
          fmt::format("Index of control of (dσ₁′ − dσ₃′/R, dε₁ + {}R dε₃) over R; control is lost "
                      "where it is below 0{}. {}",
                      axisymmetric ? "2" : "", roots.empty() ? "" : " (roots " + roots + ")",
                      simulated_with(subject))};
}

}  // namespace triax::src
