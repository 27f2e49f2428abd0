// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/figures/strain_paths_figure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/plot/axes.hpp"
#include "src/plot/curve_labels.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/shapes.hpp"

namespace triax::src {
namespace {

constexpr int kStrainPathsWidth = 960, kStrainPathsHeight = 480 + kOriginHeight;
constexpr double kRoomForLabels = 0.14;  // of the axis of strain, to the right of the curves

QCPScatterStyle peak_marker() {
  return {QCPScatterStyle::ssCircle, line(kInk, 1.4), QBrush(Qt::white), 9};
}
QCPScatterStyle unstable_marker() {
  return {QCPScatterStyle::ssCross, line(kVermilion, 2.2), Qt::NoBrush, 9};
}

QPointF in_stress_plane(const sim::StrainPathPoint& at) { return {at.p * 1e-3, at.q * 1e-3}; }
QPointF over_strain(const sim::StrainPathPoint& at) {
  return {at.axial_strain * 100, at.control_stress * 1e-3};
}
using Place = QPointF (*)(const sim::StrainPathPoint&);

std::string label_of(const sim::StrainPath& path) { return fmt::format("R = {:g}", path.R); }

RangeOf range_of(const std::vector<sim::StrainPath>& paths, Place place, bool x) {
  RangeOf range;
  range.add(0);
  for (const auto& path : paths)
    for (const auto& point : path.points) range.add(x ? place(point).x() : place(point).y());
  return range;
}

void draw_paths(QCPAxisRect& rect, const std::vector<sim::StrainPath>& paths, Place place) {
  Points peaks, unstable;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    Points points;
    for (const auto& point : paths[i].points) points.push_back(place(point));
    draw_curve(rect, points, curve_pen(i, 1.6));
    if (paths[i].peak) peaks.push_back(place(*paths[i].peak));
    if (paths[i].first_unstable) unstable.push_back(place(*paths[i].first_unstable));
  }
  draw_markers(rect, peaks, peak_marker());
  draw_markers(rect, unstable, unstable_marker());
}

/// The peak, or the highest point of a curve without one, over the axial strain.
QPointF top_of(const sim::StrainPath& path) {
  return over_strain(path.peak ? *path.peak
                               : *std::ranges::max_element(path.points, {},
                                                           &sim::StrainPathPoint::control_stress));
}

std::vector<LabelledCurve> labelled(const std::vector<sim::StrainPath>& paths) {
  std::vector<LabelledCurve> curves;
  for (const auto& path : paths) {
    Points points;
    for (const auto& point : path.points) points.push_back(over_strain(point));
    curves.push_back(
        {std::move(points), top_of(path), label_of(path), curve_pen(curves.size()).color()});
  }
  return curves;
}

std::string caption_of(const std::vector<sim::StrainPath>& paths, const Subject& subject) {
  const auto with_peak =
      std::ranges::count_if(paths, [](const auto& path) { return path.peak.has_value(); });
  return fmt::format(
      "Proportional strain paths dε₁ + 2R dε₃ = 0: {} of {} have a peak of "
      "σ₁′ − σ₃′/R, where W₂ vanishes. {}",
      with_peak, paths.size(), simulated_with(subject));
}

}  // namespace

Drawing strain_paths_figure(const std::vector<sim::StrainPath>& all, const Subject& subject) {
  std::vector<sim::StrainPath> paths;
  std::ranges::copy_if(all, std::back_inserter(paths),
                       [](const auto& path) { return !path.points.empty(); });
  if (paths.empty()) return {};
  auto plot = make_plot(kStrainPathsWidth, kStrainPathsHeight);
  auto& left = *plot->axisRect();
  auto& right = add_axes_beside(*plot);
  style_axes(left, "mean effective stress p′ (kPa)", "deviator stress q (kPa)");
  style_axes(right, "axial strain ε₁ (%)", "σ₁′ − σ₃′/R (kPa)");
  for (std::size_t i = 0; i < paths.size(); ++i)
    draw_curve(left, {}, curve_pen(i, 1.6), label_of(paths[i]));
  draw_markers(left, {}, peak_marker(), "peak of σ₁′ − σ₃′/R");
  draw_markers(left, {}, unstable_marker(), "W₂ = 0");
  legend_below(*plot, 5);
  origin_below(*plot, subject);

  const auto set_ranges = [&](QCPAxisRect& rect, Place place, double right_margin) {
    auto x = range_of(paths, place, true).with_margin(0.08, true);
    x.upper += right_margin * x.size();
    rect.axis(QCPAxis::atBottom)->setRange(x);
    rect.axis(QCPAxis::atLeft)->setRange(range_of(paths, place, false).with_margin(0.08, true));
  };
  set_ranges(left, in_stress_plane, 0.05);
  set_ranges(right, over_strain, kRoomForLabels);
  draw_paths(left, paths, in_stress_plane);
  draw_paths(right, paths, over_strain);
  label_beside(right, labelled(paths));
  return {std::move(plot), caption_of(paths, subject)};
}

}  // namespace triax::src
