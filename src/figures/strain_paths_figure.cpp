#include "src/figures/strain_paths_figure.hpp"

#include <fmt/format.h>

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "src/figures/axes.hpp"
#include "src/figures/plot_style.hpp"
#include "src/figures/point_labels.hpp"
#include "src/figures/shapes.hpp"

namespace triax::src {
namespace {

constexpr int kWidth = 960, kHeight = 480;
constexpr double kRoomForLabels = 0.18;  // of the axis of strain, to the right of the curves

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

/// Heights of labels in pixels, as near to where they are wanted as their own height allows; both
/// in the order of the labels.
std::vector<double> spread(const std::vector<double>& wanted, double height, double low,
                           double high) {
  std::vector<std::size_t> order(wanted.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::sort(order, {}, [&](std::size_t i) { return wanted[i]; });
  std::vector<double> placed = wanted;
  double free = low;
  for (const auto i : order) {
    placed[i] = std::max(wanted[i], free);
    free = placed[i] + height;
  }
  double limit = high;
  for (auto it = order.rbegin(); it != order.rend(); ++it) {
    placed[*it] = std::min(placed[*it], limit);
    limit = placed[*it] - height;
  }
  return placed;
}

/// R in a column to the right of the curves, with a thin line to the end of each.
void label_ends(QCPAxisRect& rect, const std::vector<sim::StrainPath>& paths, double column) {
  auto* x = rect.axis(QCPAxis::atBottom);
  auto* y = rect.axis(QCPAxis::atLeft);
  rect.parentPlot()->replot();
  const double height = QFontMetricsF(label_font()).height();
  std::vector<double> wanted;
  for (const auto& path : paths)
    wanted.push_back(y->coordToPixel(over_strain(path.points.back()).y()));
  const auto placed = spread(wanted, height, rect.top() + height, rect.bottom() - height);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const QPointF at(column, y->pixelToCoord(placed[i]));
    draw_curve(rect, {over_strain(paths[i].points.back()), at}, line(kGrey, 0.7));
    write_text(rect, at + QPointF(0.01 * x->range().size(), 0), label_of(paths[i]),
               curve_pen(i).color(), Qt::AlignLeft | Qt::AlignVCenter);
  }
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
  auto plot = make_plot(kWidth, kHeight);
  auto& left = *plot->axisRect();
  auto& right = add_axes_beside(*plot);
  style_axes(left, "mean effective stress p′ (kPa)", "deviator stress q (kPa)");
  style_axes(right, "axial strain ε₁ (%)", "σ₁′ − σ₃′/R (kPa)");
  draw_markers(left, {}, peak_marker(), "peak of σ₁′ − σ₃′/R");
  draw_markers(left, {}, unstable_marker(), "W₂ = 0");
  legend_below(*plot, 2);

  left.axis(QCPAxis::atBottom)
      ->setRange(range_of(paths, in_stress_plane, true).with_margin(0.08, true));
  left.axis(QCPAxis::atLeft)
      ->setRange(range_of(paths, in_stress_plane, false).with_margin(0.08, true));
  const auto strain = range_of(paths, over_strain, true);
  const auto strain_range = strain.with_margin(kRoomForLabels, true);
  right.axis(QCPAxis::atBottom)->setRange(strain_range);
  right.axis(QCPAxis::atLeft)
      ->setRange(range_of(paths, over_strain, false).with_margin(0.08, true));
  draw_paths(left, paths, in_stress_plane);
  draw_paths(right, paths, over_strain);

  std::vector<PointLabel> ends;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto end = in_stress_plane(paths[i].points.back());
    ends.push_back({end.x(), end.y(), label_of(paths[i]), curve_pen(i).color()});
  }
  place_labels(left, ends);
  label_ends(right, paths, strain_range.lower + 0.88 * strain_range.size());
  return {std::move(plot), caption_of(paths, subject)};
}

}  // namespace triax::src
