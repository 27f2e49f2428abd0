// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/figures/cones_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/plot/axes.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/point_labels.hpp"
#include "src/plot/shapes.hpp"

namespace triax::src {
namespace {

constexpr int kLeastWidth = 560, kConesWidth = 680, kLeastHeight = 400,
              kConesHeight = 640 + kOriginHeight;
constexpr double kArrow = 1.7;  // length of a test's arrow in radii of a fan

class Picture {
 public:
  Picture(const study::ConesPicture& data, const Subject& subject, StressAxes plane)
      : data_(data),
        subject_(subject),
        plane_(plane),
        plot_(make_plot(kConesWidth, kConesHeight)) {}

  Drawing draw() {
    style_axes(rect(),
               plane_ == StressAxes::p_q ? "mean effective stress p′ (kPa)" : "√2 σ₃′ (kPa)",
               plane_ == StressAxes::p_q ? "deviator stress q (kPa)" : "σ₁′ (kPa)");
    name_legend();
    legend_below(*plot_, 2);
    origin_below(*plot_, subject_);
    find_ranges();
    const auto radii = fan_radii();
    draw_lines();
    for (const auto& limit : data_.limits) draw_path(limit, limit_pen());
    for (const auto& states : data_.instability_lines) draw_path(states, instability_pen());
    for (const auto& boundary : data_.boundaries) draw_path(boundary, boundary_pen());
    for (const auto& path : data_.paths) draw_path(path, path_pen());
    for (std::size_t i = 0; i < radii.size(); ++i) draw_fans(data_.states[i], radii[i]);
    for (const auto& state : data_.states) mark_state(state);
    for (const auto& test : data_.tests) draw_test(test);
    place_labels(*plot_, labels_);
    return {std::move(plot_), caption()};
  }

 private:
  QCPAxisRect& rect() { return *plot_->axisRect(); }
  static QPen limit_pen() { return line(kInk, 1.4); }
  static QPen instability_pen() { return line(kPurple, 1.8, Qt::DotLine); }
  static QPen hydrostatic_pen() { return line(kGrey, 1, Qt::DashDotLine); }
  static QPen path_pen() { return line(kBlue, 1.4); }
  static QPen boundary_pen() { return line(kBlue, 1.4, Qt::DashLine); }
  static QColor fan_fill() { return {0xF2, 0xB1, 0x8A}; }
  static QPen fan_pen() { return line(kVermilion, 1); }
  static QCPScatterStyle state_marker(bool stable) {
    return {QCPScatterStyle::ssCircle, line(stable ? kGrey : kVermilion, 1),
            stable ? QBrush(Qt::white) : QBrush(kVermilion), stable ? 4.0 : 3.0};
  }
  static QCPScatterStyle test_marker(bool simulated) {
    return {QCPScatterStyle::ssCircle, line(kInk, 1.6),
            simulated ? QBrush(Qt::white) : QBrush(kInk), 7};
  }

  QPointF kPa(const study::TriaxialState& state) const { return position(state, plane_) * 1e-3; }

  bool has(bool stable) const {
    return std::ranges::any_of(data_.states,
                               [&](const auto& s) { return s.cones.empty() == stable; });
  }
  /// States or tests of compression (1), of extension (-1).
  bool has_side(int sign) const {
    const auto on_side = [&](const auto& at) { return sign * at.state.q > 0; };
    return std::ranges::any_of(data_.states, on_side) || std::ranges::any_of(data_.tests, on_side);
  }
  // M is that of compression: extension has another one, which laws do not tell.
  bool draws_limit_line() const {
    return data_.limit_stress_ratio && data_.limits.empty() && (has_side(1) || !has_side(-1));
  }
  bool has_test(bool simulated) const {
    return std::ranges::any_of(data_.tests,
                               [&](const auto& t) { return t.simulated == simulated; });
  }

  // Entries only: what is drawn comes after the ranges, which depend on the legend's height.
  void name_legend() {
    if (has(false)) draw_area(rect(), {}, fan_fill(), fan_pen(), "directions with W₂ < 0");
    if (has(true)) draw_markers(rect(), {}, state_marker(true), "state without any");
    if (!data_.paths.empty()) draw_curve(rect(), {}, path_pen(), "stress path (simulated)");
    if (!data_.boundaries.empty())
      draw_curve(rect(), {}, boundary_pen(), "boundary of the bifurcation domain");
    if (!data_.limits.empty()) draw_curve(rect(), {}, limit_pen(), "plastic limit");
    if (draws_limit_line())
      draw_curve(rect(), {}, limit_pen(),
                 fmt::format("limit line{}, M = {:.2f}", has_side(-1) ? " in compression" : "",
                             *data_.limit_stress_ratio));
    if (!data_.instability_lines.empty())
      draw_curve(rect(), {}, instability_pen(), "instability line (isotropic unloading)");
    if (plane_ == StressAxes::rendulic)
      draw_curve(rect(), {}, hydrostatic_pen(), "hydrostatic axis σ₁′ = σ₃′");
    for (const bool simulated : {false, true})
      if (has_test(simulated))
        draw_markers(rect(), {}, test_marker(simulated),
                     simulated ? "increment of a simulated test" : "increment of a recorded test");
  }

  void find_ranges() {
    RangeOf x, y;
    const auto add = [&](const study::TriaxialState& state) {
      x.add(kPa(state).x());
      y.add(kPa(state).y());
    };
    add({0, 0});
    for (const auto& at : data_.states) add(at.state);
    for (const auto* lines :
         {&data_.paths, &data_.boundaries, &data_.limits, &data_.instability_lines})
      for (const auto& states : *lines) std::ranges::for_each(states, add);
    for (const auto& test : data_.tests) add(test.state);
    const auto across = x.with_margin(0.10, true), up = y.with_margin(0.12, true);
    trim(up.size() / across.size());
    set_equal_ranges(rect(), across, up);
    // The origin stays in its corner.
    if (across.lower >= 0) plot_->xAxis->setRange(0, plot_->xAxis->range().size());
    if (up.lower >= 0) plot_->yAxis->setRange(0, plot_->yAxis->range().size());
    plot_->replot();
  }

  /// A plot as high, or as broad, as the data need where both axes have one scale.
  void trim(double height_over_width) {
    plot_->replot();
    const int beside = kConesWidth - rect().width(), below = kConesHeight - rect().height();
    const int high = static_cast<int>(rect().width() * height_over_width);
    const int broad = static_cast<int>(rect().height() / height_over_width);
    const int width = std::clamp(broad + beside, kLeastWidth, kConesWidth);
    const int height = std::clamp(high + below, kLeastHeight, kConesHeight);
    resize_plot(*plot_, width, height);
  }

  /// Of the distances from each unstable state to the nearest other, kPa; empty: one state alone.
  std::vector<double> nearest_distances() const {
    std::vector<double> distances;
    for (const auto& here : data_.states) {
      double nearest = 0;
      for (const auto& there : data_.states) {
        const QPointF way = kPa(here.state) - kPa(there.state);
        const double distance = std::hypot(way.x(), way.y());
        if (there.cones.empty() || !(distance > 0)) continue;
        nearest = nearest > 0 ? std::min(nearest, distance) : distance;
      }
      distances.push_back(nearest);
    }
    return distances;
  }

  /// Large where there is room, and small where neighbours would be covered; kPa, by state.
  std::vector<double> fan_radii() {
    const double range = std::hypot(plot_->xAxis->range().size(), plot_->yAxis->range().size());
    // A unit of the Rendulic plane is up to √(3/2) long in the other.
    const double reach = plane_ == StressAxes::p_q ? 0.9 / std::sqrt(1.5) : 0.9;
    auto radii = nearest_distances();
    auto sorted = radii;
    std::ranges::sort(sorted);
    const double usual = sorted.empty() ? 0 : sorted[sorted.size() / 2];
    radius_ = usual > 0 ? std::clamp(reach * usual, 0.03 * range, 0.06 * range) : 0.06 * range;
    for (double& radius : radii)
      radius = radius > 0 ? std::clamp(reach * radius, 0.015 * range, radius_) : radius_;
    return radii;
  }

  void draw_ray(const study::TriaxialState& towards, const QPen& pen) {
    const QPointF way = position(towards, plane_);
    const auto x = plot_->xAxis->range(), y = plot_->yAxis->range();
    double length = way.x() > 0 ? x.upper / way.x() : x.upper;
    if (way.y() > 0) length = std::min(length, y.upper / way.y());
    if (way.y() < 0) length = std::min(length, y.lower / way.y());
    draw_curve(rect(), {{0, 0}, way * length}, pen);
  }

  void draw_lines() {
    if (plane_ == StressAxes::rendulic) draw_ray({1, 0}, hydrostatic_pen());
    if (draws_limit_line()) draw_ray({1, *data_.limit_stress_ratio}, limit_pen());
  }

  void draw_path(const std::vector<study::TriaxialState>& path, const QPen& pen) {
    Points points;
    for (const auto& state : path) points.push_back(kPa(state));
    draw_curve(rect(), points, pen);
  }

  void draw_fans(const study::ConesAtState& at, double radius) {
    const QPointF tip = kPa(at.state);
    for (const auto& [from, to] : at.cones) {
      const bool whole = to - from >= 2 * std::numbers::pi - 1e-9;
      const int steps = std::max(2, static_cast<int>(std::ceil((to - from) / sim::radians(2))));
      Points points;
      if (!whole) points.push_back(tip);
      for (int i = 0; i <= steps; ++i)
        points.push_back(
            tip + radius * increment(std::lerp(from, to, static_cast<double>(i) / steps), plane_));
      draw_area(rect(), points, fan_fill(), fan_pen());
    }
  }

  void mark_state(const study::ConesAtState& at) {
    draw_markers(rect(), {kPa(at.state)}, state_marker(at.cones.empty()));
  }

  void draw_test(const study::TestIncrement& test) {
    const QPointF at = kPa(test.state);
    draw_arrow(rect(), at, at + kArrow * radius_ * increment(test.angle, plane_), line(kInk, 1.8));
    draw_markers(rect(), {at}, test_marker(test.simulated));
    labels_.push_back({at.x(), at.y(), test.name, kInk});
  }

  std::string caption() const {
    const auto unstable =
        std::ranges::count_if(data_.states, [](const auto& state) { return !state.cones.empty(); });
    auto text = fmt::format(
        "Cones of unstable stress directions in the {} plane: {} of {} states "
        "have directions with W₂ < 0",
        plane_ == StressAxes::p_q ? "q-p′" : "Rendulic", unstable, data_.states.size());
    if (!data_.tests.empty()) text += "; arrows are the stress increments of tests";
    return text + ". " + simulated_with(subject_);
  }

  const study::ConesPicture& data_;
  const Subject& subject_;
  StressAxes plane_;
  OwnPlot plot_;
  std::vector<PointLabel> labels_;
  double radius_ = 0;  // of a fan with room around it, kPa
};

}  // namespace

QPointF position(const study::TriaxialState& state, StressAxes plane) {
  if (plane == StressAxes::p_q) return {state.p, state.q};
  return {std::numbers::sqrt2 * (state.p - state.q / 3), state.p + 2 * state.q / 3};
}

QPointF increment(double angle, StressAxes plane) {
  const QPointF unit(std::cos(angle), std::sin(angle));
  if (plane == StressAxes::rendulic) return unit;
  const sim::AxisymmetricStress s{unit.y(), unit.x() / std::numbers::sqrt2};
  return {sim::mean_stress(s), sim::deviator_stress(s)};
}

Drawing cones_figure(const study::ConesPicture& picture, const Subject& subject, StressAxes plane) {
  if (picture.states.empty() && picture.tests.empty()) return {};
  return Picture(picture, subject, plane).draw();
}

}  // namespace triax::src
