#include "src/figures/strain_paths_figure.hpp"

#include <fmt/format.h>

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "src/figures/axes.hpp"
#include "src/figures/plot_style.hpp"
#include "src/figures/shapes.hpp"

namespace triax::src {
namespace {

constexpr int kWidth = 960, kHeight = 480 + kOriginHeight;
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

/// Heights of the column of labels, px downwards: as near to those wanted, which rise, as a
/// distance between neighbours and the border allow.
std::vector<double> spread(std::vector<double> wanted, double distance, double border) {
  for (std::size_t i = 1; i < wanted.size(); ++i)
    wanted[i] = std::max(wanted[i], wanted[i - 1] + distance);
  for (std::size_t i = wanted.size(); i-- > 0; border -= distance)
    wanted[i] = std::min(wanted[i], border);
  return wanted;
}

/// R of each curve in a column as near to the peaks as no curve passes, with a line to the peak.
class PeakLabels {
 public:
  PeakLabels(QCPAxisRect& rect, const std::vector<sim::StrainPath>& paths)
      : rect_(rect), paths_(paths), order_(paths.size()) {
    rect.parentPlot()->replot();
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::stable_sort(order_, {},
                             [&](std::size_t i) { return pixel(top_of(paths_[i])).y(); });
  }

  void draw() {
    std::vector<double> wanted;
    for (const std::size_t i : order_) wanted.push_back(pixel(top_of(paths_[i])).y());
    const double height = std::ceil(metrics_.height()) + 2;
    const auto heights = spread(wanted, height, rect_.bottom() - height);
    const double x = column(heights);
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const auto& path = paths_[order_[k]];
      const QPointF at = coordinates({x, heights[k]});
      auto* leader =
          draw_curve(rect_, {top_of(path), coordinates({x - kGap, heights[k]})}, line(kGrey, 0.7));
      lay_behind(*leader);
      write_text(rect_, at, label_of(path), curve_pen(order_[k]).color(),
                 Qt::AlignLeft | Qt::AlignVCenter);
    }
  }

 private:
  static constexpr double kGap = 3;  // px between a line and its words

  QPointF pixel(const QPointF& at) const {
    return {rect_.axis(QCPAxis::atBottom)->coordToPixel(at.x()),
            rect_.axis(QCPAxis::atLeft)->coordToPixel(at.y())};
  }
  QPointF coordinates(const QPointF& pixel) const {
    return {rect_.axis(QCPAxis::atBottom)->pixelToCoord(pixel.x()),
            rect_.axis(QCPAxis::atLeft)->pixelToCoord(pixel.y())};
  }

  /// The left of the column: to the right of every curve at its height and of every peak.
  double column(const std::vector<double>& heights) const {
    const double clear = 0.7 * metrics_.height();
    double x = rect_.left();
    for (const auto& path : paths_) {
      x = std::max(x, pixel(top_of(path)).x());
      for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
        const QPointF a = pixel(over_strain(path.points[i])),
                      b = pixel(over_strain(path.points[i + 1]));
        const double low = std::min(a.y(), b.y()), high = std::max(a.y(), b.y());
        if (high > heights.front() - clear && low < heights.back() + clear)
          x = std::max({x, a.x(), b.x()});
      }
    }
    double widest = 0;
    for (const auto& path : paths_)
      widest = std::max(widest, metrics_.horizontalAdvance(QString::fromStdString(label_of(path))));
    return std::min(x + kDistance, rect_.right() - widest - 2 * kGap);
  }

  static constexpr double kDistance = 24;  // px from the curves

  QCPAxisRect& rect_;
  const std::vector<sim::StrainPath>& paths_;
  std::vector<std::size_t> order_;  // from above
  QFontMetricsF metrics_{label_font()};
};

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
  PeakLabels(right, paths).draw();
  return {std::move(plot), caption_of(paths, subject)};
}

}  // namespace triax::src
