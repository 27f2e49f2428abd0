// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/figures/grain_paths_figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/plot/axes.hpp"
#include "src/plot/curve_labels.hpp"
#include "src/plot/from_zero.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/point_labels.hpp"
#include "src/plot/shapes.hpp"

namespace triax::src {
namespace {

constexpr int kGrainPathsWidth = 960, kGrainPathsHeight = 480 + kOriginHeight;
constexpr double kRoomForLabels = 0.14;  // of the axis of strain, to the right of the curves

using At = sim::GrainPathPoint;
using Place = QPointF (*)(const At&);

QPointF in_stress_plane(const At& at) { return {at.p_pa * 1e-3, at.q_pa * 1e-3}; }
QPointF control_over_strain(const At& at) {
  return {at.strain.axial * 100, at.path_stress_pa * 1e-3};
}
QPointF q_over_strain(const At& at) { return {at.strain.axial * 100, at.q_pa * 1e-3}; }
QPointF volume_over_strain(const At& at) {
  return {at.strain.axial * 100, at.volumetric_strain * 100};
}
QPointF p_over_volume(const At& at) { return {at.volumetric_strain * 100, at.p_pa * 1e-3}; }
QPointF porosity_over_volume(const At& at) { return {at.volumetric_strain * 100, at.porosity}; }

QCPScatterStyle peak_marker() {
  return {QCPScatterStyle::ssCircle, line(kInk, 1.4), QBrush(Qt::white), 9};
}
QCPScatterStyle unstable_marker() {
  return {QCPScatterStyle::ssCross, line(kVermilion, 2.2), Qt::NoBrush, 9};
}
QCPScatterStyle mark_marker() {
  return {QCPScatterStyle::ssDiamond, line(kInk, 1.4), QBrush(kOrange), 10};
}

/// One of the two sides of a figure.
struct Side {
  const char *x_title, *y_title;
  Place place;
  bool from_zero = true;  ///< of the left axis
  double room_right = 0;  ///< of the range of the axis below
};

void set_ranges(QCPAxisRect& rect, const std::vector<study::GrainCurve>& paths, const Side& side) {
  RangeOf x, y;
  x.add(0);
  if (side.from_zero) y.add(0);
  for (const auto& path : paths)
    for (const auto& point : path.points) {
      x.add(side.place(point).x());
      y.add(side.place(point).y());
    }
  auto across = x.with_margin(0.06, true);
  across.upper += side.room_right * across.size();
  rect.axis(QCPAxis::atBottom)->setRange(across);
  rect.axis(QCPAxis::atLeft)->setRange(from_zero(y.with_margin(0.08, true)));
}

void draw_paths(QCPAxisRect& rect, const std::vector<study::GrainCurve>& paths, Place place) {
  Points peaks, unstable, marks;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto& path = paths[i];
    Points points;
    for (const auto& point : path.points) points.push_back(place(point));
    draw_curve(rect, points, curve_pen(i, 1.6));
    if (path.peak) peaks.push_back(points[*path.peak]);
    if (path.first_negative) unstable.push_back(points[*path.first_negative]);
    for (const auto& mark : path.marks) marks.push_back(place(mark.at));
  }
  draw_markers(rect, peaks, peak_marker());
  draw_markers(rect, unstable, unstable_marker());
  draw_markers(rect, marks, mark_marker());
}

void name_marks(QCPAxisRect& rect, const std::vector<study::GrainCurve>& paths, Place place) {
  std::vector<PointLabel> labels;
  for (const auto& path : paths)
    for (const auto& mark : path.marks) {
      const QPointF at = place(mark.at);
      labels.push_back({at.x(), at.y(), mark.name, kInk});
    }
  place_labels(rect, labels);
}

template <class Member>
bool any(const std::vector<study::GrainCurve>& paths, Member member) {
  return std::ranges::any_of(paths, member);
}

void name_entries(QCPAxisRect& rect, const std::vector<study::GrainCurve>& paths) {
  for (std::size_t i = 0; i < paths.size(); ++i)
    draw_curve(rect, {}, curve_pen(i, 1.6), paths[i].label);
  if (any(paths, [](const auto& p) { return p.peak.has_value(); }))
    draw_markers(rect, {}, peak_marker(), "peak of σ₁ − σ₃/R");
  if (any(paths, [](const auto& p) { return p.first_negative.has_value(); }))
    draw_markers(rect, {}, unstable_marker(), "W₂ < 0 from here");
  if (any(paths, [](const auto& p) { return !p.marks.empty(); }))
    draw_markers(rect, {}, mark_marker(), "saved state");
}

std::vector<LabelledCurve> labelled(const std::vector<study::GrainCurve>& paths, Place place) {
  std::vector<LabelledCurve> curves;
  for (const auto& path : paths) {
    Points points;
    for (const auto& point : path.points) points.push_back(place(point));
    const QPointF top =
        path.peak ? points[*path.peak] : *std::ranges::max_element(points, {}, &QPointF::y);
    curves.push_back({std::move(points), top, path.label, curve_pen(curves.size()).color()});
  }
  return curves;
}

/// Both sides with curves, markers and names of marks; the labels beside the curves on the right.
OwnPlot drawn(const std::vector<study::GrainCurve>& paths, const Side& left_side,
              const Side& right_side, bool labels, const Subject& subject) {
  auto plot = make_plot(kGrainPathsWidth, kGrainPathsHeight);
  auto& left = *plot->axisRect();
  auto& right = add_axes_beside(*plot);
  style_axes(left, left_side.x_title, left_side.y_title);
  style_axes(right, right_side.x_title, right_side.y_title);
  name_entries(left, paths);
  legend_below(*plot, 5);
  origin_below(*plot, subject);
  set_ranges(left, paths, left_side);
  set_ranges(right, paths, right_side);
  draw_paths(left, paths, left_side.place);
  draw_paths(right, paths, right_side.place);
  if (labels) label_beside(right, labelled(paths, right_side.place));
  name_marks(left, paths, left_side.place);
  name_marks(right, paths, right_side.place);
  return plot;
}

std::vector<study::GrainCurve> with_points(const std::vector<study::GrainCurve>& all) {
  std::vector<study::GrainCurve> paths;
  std::ranges::copy_if(all, std::back_inserter(paths),
                       [](const auto& path) { return !path.points.empty(); });
  return paths;
}

std::string labels_of(const std::vector<study::GrainCurve>& paths) {
  std::string words;
  for (const auto& path : paths) words += (words.empty() ? "" : ", ") + path.label;
  return words;
}

}  // namespace

Drawing grain_strain_paths_figure(const std::vector<study::GrainCurve>& all,
                                  const Subject& subject) {
  const auto paths = with_points(all);
  if (paths.empty()) return {};
  auto plot =
      drawn(paths, {"mean stress p (kPa)", "deviator stress q (kPa)", in_stress_plane},
            {"axial strain ε₁ (%)", "σ₁ − σ₃/R (kPa)", control_over_strain, true, kRoomForLabels},
            true, subject);
  const auto fallen =
      std::ranges::count_if(paths, [](const auto& path) { return path.peak.has_value(); });
  return {
      std::move(plot),
      fmt::format("Proportional strain paths dε₁ + 2R dε₃ = 0 of a specimen of grains: on {} of "
                  "{} paths σ₁ − σ₃/R has a peak, where W₂ vanishes. {}",
                  fallen, paths.size(), simulated_with(subject))};
}

Drawing grain_shear_figure(const std::vector<study::GrainCurve>& all, const Subject& subject) {
  const auto paths = with_points(all);
  if (paths.empty()) return {};
  auto plot = drawn(paths, {"axial strain ε₁ (%)", "deviator stress q (kPa)", q_over_strain},
                    {"axial strain ε₁ (%)", "volumetric strain ε_v (%)", volume_over_strain}, false,
                    subject);
  return {std::move(plot),
          fmt::format("Deviator stress (left) and volumetric strain (right) over the axial strain "
                      "of {}. {}",
                      labels_of(paths), simulated_with(subject))};
}

Drawing grain_compression_figure(const std::vector<study::GrainCurve>& all,
                                 const Subject& subject) {
  const auto paths = with_points(all);
  if (paths.empty()) return {};
  auto plot = drawn(paths, {"volumetric strain ε_v (%)", "mean stress p (kPa)", p_over_volume},
                    {"volumetric strain ε_v (%)", "porosity n (–)", porosity_over_volume, false},
                    false, subject);
  return {std::move(plot),
          fmt::format("Mean stress (left) and porosity (right) over the volumetric "
                      "strain of {}. {}",
                      labels_of(paths), simulated_with(subject))};
}

}  // namespace triax::src
