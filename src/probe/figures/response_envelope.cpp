// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/figures/response_envelope.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/plot/axes.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/point_labels.hpp"
#include "src/plot/shapes.hpp"

namespace triax::src {
namespace {

constexpr int kResponseEnvelopeWidth = 900, kResponseEnvelopeHeight = 500 + kOriginHeight;
constexpr double kMicro = 1e6, kKilo = 1e-3;  // strain in 10⁻⁶, stress in kPa

QPen stable_pen() { return line(kBlue, 1.6); }
QPen unstable_pen() { return line(kVermilion, 2.8); }

class Envelope {
 public:
  Envelope(const sim::Circle& circle, double norm, const Subject& subject)
      : subject_(subject), norm_(norm), of_stress_(subject.kind == sim::ProbeKind::stress) {
    for (const auto& probe : circle.probes) {
      const auto& imposed = of_stress_ ? probe.stress : probe.strain;
      const auto& answer = of_stress_ ? probe.strain : probe.stress;
      if (probe.answered) any_ = true;
      const double scale = probe.answered ? norm / imposed.norm() : 0;
      const double in = of_stress_ ? kKilo : kMicro, out = of_stress_ ? kMicro : kKilo;
      points_.push_back({probe.angle, probe.answered, probe.normalised < sim::kUnstable,
                         QPointF(std::cos(probe.angle), std::sin(probe.angle)) * norm * in,
                         QPointF(answer.x(), answer.y()) * scale * out});
    }
  }

  bool empty() const { return !any_; }

  Drawing draw() {
    auto plot = make_plot(kResponseEnvelopeWidth, kResponseEnvelopeHeight);
    auto& left = *plot->axisRect();
    auto& right = add_axes_beside(*plot);
    for (auto* rect : {&left, &right}) {
      const bool stress = (rect == &left) == of_stress_;
      style_axes(*rect, title(true, stress), title(false, stress));
    }
    draw_curve(left, {}, stable_pen(), "W₂ > 0");
    draw_curve(left, {}, unstable_pen(), "W₂ < 0");
    draw_markers(left, {}, mark(), "α every 30°");
    legend_below(*plot, 3);
    origin_below(*plot, subject_);
    draw_side(left, &Point::imposed);
    draw_side(right, &Point::answer);
    return {std::move(plot), caption()};
  }

 private:
  struct Point {
    double angle;
    bool answered, unstable;
    QPointF imposed, answer;
  };
  using Part = QPointF Point::*;

  static QCPScatterStyle mark() {
    return {QCPScatterStyle::ssCircle, line(kInk, 1.2), QBrush(Qt::white), 6};
  }

  std::string title(bool x, bool stress) const {
    const auto name = stress ? (x ? stress_x_name(subject_.plane) : stress_y_name())
                             : (x ? strain_x_name(subject_.plane) : strain_y_name());
    return name + (stress ? " (kPa)" : " (10⁻⁶)");
  }

  void draw_side(QCPAxisRect& rect, Part part) {
    RangeOf x, y;
    for (const auto& point : points_) {
      if (!point.answered) continue;
      x.add((point.*part).x());
      y.add((point.*part).y());
    }
    x.add(0);
    y.add(0);
    set_equal_ranges(rect, x.with_margin(0.16, false), y.with_margin(0.16, false));
    rect.parentPlot()->replot();
    draw_runs(rect, part, false);
    draw_runs(rect, part, true);
    draw_marks(rect, part);
  }

  // Between two neighbours the line has the look of the unstable one, if one is.
  void draw_runs(QCPAxisRect& rect, Part part, bool unstable) {
    constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
    Points run;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Point &from = points_[i], &to = points_[(i + 1) % points_.size()];
      if (!from.answered || !to.answered || (from.unstable || to.unstable) != unstable) continue;
      const bool joined = !run.empty() && run.back() == from.*part;
      if (!joined && !run.empty()) run.emplace_back(kGap, kGap);
      if (!joined) run.push_back(from.*part);
      run.push_back(to.*part);
    }
    draw_curve(rect, run, unstable ? unstable_pen() : stable_pen());
  }

  /// The probe at each 30°, where there is one.
  void draw_marks(QCPAxisRect& rect, Part part) {
    Points marks;
    std::vector<PointLabel> labels;
    for (int degrees = 0; degrees < 360; degrees += 30) {
      const auto found = std::ranges::find_if(points_, [&](const Point& point) {
        return point.answered && std::abs(point.angle - sim::radians(degrees)) < 1e-6;
      });
      if (found == points_.end()) continue;
      const QPointF at = (*found).*part;
      const auto text = fmt::format("{}°", degrees);
      const QColor colour = found->unstable ? kVermilion : kInk;
      marks.push_back(at);
      if (part == &Point::imposed)
        write_text(rect, 1.04 * at, text, colour, part_away({0, 0}, at));
      else
        labels.push_back({at.x(), at.y(), text, colour});
    }
    draw_markers(rect, marks, mark());
    draw_markers(rect, {{0, 0}}, {QCPScatterStyle::ssPlus, line(kGrey, 1), Qt::NoBrush, 8});
    place_labels(rect, labels);
  }

  std::string caption() const {
    const bool any_unstable = std::ranges::any_of(points_, &Point::unstable);
    return fmt::format(
        "{} probes of norm {} (left) and the envelope of the {} responses (right), {}. {}",
        of_stress_ ? "Stress" : "Strain",
        of_stress_ ? fmt::format("{:g} kPa", norm_ * kKilo)
                   : fmt::format("{:g}·10⁻⁶", norm_ * kMicro),
        of_stress_ ? "strain" : "stress",
        any_unstable ? "directions with W₂ < 0 vermilion and bolder" : "W₂ > 0 in all directions",
        simulated_with(subject_));
  }

  const Subject& subject_;
  double norm_;
  bool of_stress_;
  bool any_ = false;
  std::vector<Point> points_;
};

}  // namespace

Drawing response_envelope(const sim::Circle& circle, double norm, const Subject& subject) {
  Envelope envelope(circle, norm, subject);
  return envelope.empty() ? Drawing{} : envelope.draw();
}

}  // namespace triax::src
