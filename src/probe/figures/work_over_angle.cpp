// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/figures/work_over_angle.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/plot/angle_axis.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/shapes.hpp"

namespace triax::src {
namespace {

constexpr int kWorkOverAngleWidth = 720, kWorkOverAngleHeight = 440 + kOriginHeight;

/// α in degrees and the value of all probes, once around; a gap where one was not answered.
Points curve_of(const std::vector<sim::Probe>& probes) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  Points points;
  for (const auto& probe : probes)
    points.emplace_back(sim::degrees(probe.angle), probe.answered ? probe.normalised : kGap);
  // Closed at both ends of the axis.
  const auto& first = probes.front();
  const auto& last = probes.back();
  if (first.answered && last.answered) {
    const double from = sim::degrees(last.angle) - kTurnDeg, to = sim::degrees(first.angle);
    const double part = to > from ? (0 - from) / (to - from) : 0;
    const double at_zero = std::lerp(last.normalised, first.normalised, part);
    points.insert(points.begin(), {0, at_zero});
    points.emplace_back(kTurnDeg, at_zero);
  }
  return points;
}

void shade_cones(QCPAxisRect& rect, const std::vector<NamedCircle>& circles) {
  bool any = false;
  for (const auto& [name, circle] : circles)
    for (const auto& cone : circle.cones) {
      shade_directions(rect, sim::degrees(cone.from), sim::degrees(cone.to), kVermilion,
                       any ? "" : "cones with W₂ < 0");
      any = true;
    }
}

std::string cones_in_words(const std::vector<NamedCircle>& circles) {
  std::string words;
  for (const auto& [name, circle] : circles)
    for (const auto& cone : circle.cones)
      words += fmt::format("{}{}{:.1f}° to {:.1f}°", words.empty() ? "" : ", ",
                           name.empty() ? name : name + ' ', sim::degrees(cone.from),
                           sim::degrees(cone.to));
  return words.empty() ? "no direction has W₂ < 0"
                       : "W₂ < 0 within the cones shaded (" + words + ")";
}

}  // namespace

Drawing work_over_angle(const std::vector<NamedCircle>& circles, const Subject& subject) {
  RangeOf range;
  range.add(0);
  bool any = false;
  for (const auto& [name, circle] : circles)
    for (const auto& probe : circle.probes)
      if (probe.answered) {
        range.add(probe.normalised);
        any = true;
      }
  if (!any) return {};
  const bool stress = subject.kind == sim::ProbeKind::stress;
  auto plot = make_plot(kWorkOverAngleWidth, kWorkOverAngleHeight);
  auto& rect = *plot->axisRect();
  style_angle_axes(rect, subject.plane, subject.kind, "normalised second-order work (–)");
  plot->yAxis->setRange(range.with_margin(0.06, false));
  draw_curve(rect, {{0, 0}, {kTurnDeg, 0}}, line(kInk, 1));
  for (std::size_t i = 0; i < circles.size(); ++i)
    if (!circles[i].circle.probes.empty())
      draw_curve(rect, curve_of(circles[i].circle.probes), curve_pen(i), circles[i].name);
  shade_cones(rect, circles);
  if (stress) {
    const double unloading = sim::degrees(isotropic_unloading(subject.plane));
    const auto y = plot->yAxis->range();
    draw_curve(rect, {{unloading, y.lower}, {unloading, y.upper}}, line(kInk, 1, Qt::DotLine),
               fmt::format("isotropic unloading, {:.2f}°", unloading));
  }
  legend_below(*plot, 3);
  origin_below(*plot, subject);
  return {std::move(plot), fmt::format("Normalised second-order work over the direction of the "
                                       "increment; {}. {}",
                                       cones_in_words(circles), simulated_with(subject))};
}

}  // namespace triax::src
