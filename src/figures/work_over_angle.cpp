#include "src/figures/work_over_angle.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/figures/plot_style.hpp"
#include "src/figures/shapes.hpp"

namespace triax::src {
namespace {

constexpr int kWidth = 720, kHeight = 440 + kOriginHeight;
constexpr double kTurn = 360;

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
    const double from = sim::degrees(last.angle) - kTurn, to = sim::degrees(first.angle);
    const double part = to > from ? (0 - from) / (to - from) : 0;
    const double at_zero = std::lerp(last.normalised, first.normalised, part);
    points.insert(points.begin(), {0, at_zero});
    points.emplace_back(kTurn, at_zero);
  }
  return points;
}

void shade(QCPAxisRect& rect, double from, double to, const std::string& name) {
  const auto range = rect.axis(QCPAxis::atLeft)->range();
  QColor fill = kVermilion;
  fill.setAlpha(45);
  auto* area = draw_area(
      rect, {{from, range.lower}, {to, range.lower}, {to, range.upper}, {from, range.upper}}, fill,
      Qt::NoPen, name);
  lay_behind(*area);
}

/// A cone that passes α = 0 is shaded in two pieces.
void shade_cones(QCPAxisRect& rect, const std::vector<NamedCircle>& circles) {
  bool any = false;
  for (const auto& [name, circle] : circles)
    for (const auto& cone : circle.cones) {
      const double from = sim::degrees(cone.from), to = sim::degrees(cone.to);
      const char* entry = any ? "" : "cones with W₂ < 0";
      shade(rect, from, std::min(to, kTurn), entry);
      if (to > kTurn) shade(rect, 0, to - kTurn, "");
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
  auto plot = make_plot(kWidth, kHeight);
  auto& rect = *plot->axisRect();
  style_axes(
      rect,
      fmt::format("direction α of the {} increment from {} (°)", stress ? "stress" : "strain",
                  stress ? stress_x_name(subject.plane) : strain_x_name(subject.plane)),
      "normalised second-order work (–)");
  const QSharedPointer<QCPAxisTickerFixed> ticker(new QCPAxisTickerFixed);
  ticker->setTickStep(30);
  plot->xAxis->setTicker(ticker);
  plot->xAxis->setRange(0, kTurn);
  plot->yAxis->setRange(range.with_margin(0.06, false));
  draw_curve(rect, {{0, 0}, {kTurn, 0}}, line(kInk, 1));
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
