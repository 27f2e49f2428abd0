// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/figures/circular_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/plot/directions.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/polar_frame.hpp"

namespace triax::src {
namespace {

constexpr int kCircularDiagramWidth = 620, kCircularDiagramHeight = 690 + kOriginHeight;
const double kStep = sim::radians(1);
constexpr double kPositiveWidth = 1.6, kNegativeWidth = 2.8;

/// Least and largest normalised work of the answered probes of all circles.
struct Extremes {
  double least = 0, largest = 0;
  bool any = false;
};

Extremes extremes(const std::vector<NamedCircle>& circles) {
  Extremes found;
  for (const auto& [name, circle] : circles)
    for (const auto& probe : circle.probes) {
      if (!probe.answered) continue;
      const double v = probe.normalised;
      found.least = found.any ? std::min(found.least, v) : v;
      found.largest = found.any ? std::max(found.largest, v) : v;
      found.any = true;
    }
  return found;
}

double normalised(const sim::Probe& probe) { return probe.normalised; }

void draw_circles(QCPAxisRect& rect, const std::vector<NamedCircle>& circles,
                  const std::function<double(double)>& radius) {
  for (std::size_t i = 0; i < circles.size(); ++i)
    for (const auto& run : signed_runs(circles[i].circle.probes, normalised, kStep)) {
      Points points;
      for (const auto& [angle, v] : run.points) points.push_back(polar(radius(v), angle));
      draw_curve(rect, points,
                 line(run.negative ? kVermilion : kBlue,
                      run.negative ? kNegativeWidth : kPositiveWidth, curve_style(i)));
    }
}

void add_legend_line(QCPAxisRect& rect, const QPen& pen, const std::string& name) {
  draw_curve(rect, {}, pen, name);
}

/// One entry a state, and the two signs. Before the frame: the legend takes room.
void add_legend(QCustomPlot& plot, const std::vector<NamedCircle>& circles,
                const std::string& beyond_zero, const std::string& within_zero) {
  auto& rect = *plot.axisRect();
  for (std::size_t i = 0; i < circles.size(); ++i)
    add_legend_line(rect, line(kInk, kPositiveWidth, curve_style(i)), circles[i].name);
  add_legend_line(rect, line(kBlue, kPositiveWidth), beyond_zero);
  add_legend_line(rect, line(kVermilion, kNegativeWidth), within_zero);
}

bool marks_unloading(const Subject& subject) { return subject.kind == sim::ProbeKind::stress; }

std::string unloading_name(const Subject& subject) {
  return fmt::format("isotropic unloading, {:.2f}°",
                     sim::degrees(isotropic_unloading(subject.plane)));
}

void mark_unloading(QCPAxisRect& rect, const Subject& subject, double radius) {
  if (!marks_unloading(subject)) return;
  const double angle = isotropic_unloading(subject.plane);
  auto* mark = draw_arrow(rect, {0, 0}, polar(radius, angle), line(kGreen, 1.4));
  mark->removeFromLegend();
}

PolarFrame frame_of(const Subject& subject, double radius) {
  PolarFrame frame;
  frame.radius = radius;
  const bool stress = subject.kind == sim::ProbeKind::stress;
  frame.x_name = stress ? stress_x_name(subject.plane) : strain_x_name(subject.plane);
  frame.y_name = stress ? stress_y_name() : strain_y_name();
  return frame;
}

std::string named(const std::vector<NamedCircle>& circles) {
  std::string names;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (circles[i].name.empty()) continue;
    if (!names.empty()) names += i + 1 == circles.size() ? " and " : ", ";
    names += circles[i].name;
  }
  return names.empty() ? std::string() : " at " + names;
}

}  // namespace

double circular_constant(const std::vector<NamedCircle>& circles) {
  constexpr double kMultiple = 0.5, kClear = 0.3;
  const double least = std::min(0.0, extremes(circles).least);
  return kMultiple * std::max(1.0, std::ceil((kClear - least) / kMultiple - 1e-9));
}

Drawing circular_diagram(const std::vector<NamedCircle>& circles, const Subject& subject) {
  const auto range = extremes(circles);
  if (!range.any) return {};
  const double constant = circular_constant(circles);
  auto plot = make_plot(kCircularDiagramWidth, kCircularDiagramHeight);
  auto& rect = *plot->axisRect();
  add_legend(*plot, circles, "W₂ > 0", "W₂ < 0");
  add_legend_line(rect, line(kInk, 1.2), "circle W₂ = 0");
  if (marks_unloading(subject)) add_legend_line(rect, line(kGreen, 1.4), unloading_name(subject));
  legend_below(*plot, 3);
  origin_below(*plot, subject);
  auto frame = frame_of(subject, constant + 1);
  for (double value = -constant + 0.5; value < 0.99; value += 0.5) {
    const bool zero = std::abs(value) < 1e-9;
    frame.circles.push_back({constant + value,
                             zero        ? "0"
                             : value < 0 ? fmt::format("−{:g}", -value)
                                         : fmt::format("{:g}", value),
                             zero ? line(kInk, 1.2) : line(kGridLine, 1), ""});
  }
  draw_polar_frame(rect, frame);
  mark_unloading(rect, subject, frame.radius);
  draw_circles(rect, circles, [&](double value) { return value + constant; });
  return {std::move(plot),
          fmt::format("Circular diagram of the normalised second-order work{}: the radius is "
                      "W₂/(|dσ| |dε|) + {:g}, so that W₂ < 0 lies within the circle W₂ = 0. {}",
                      named(circles), constant, simulated_with(subject))};
}

Drawing polar_diagram(const std::vector<NamedCircle>& circles, const Subject& subject) {
  const auto range = extremes(circles);
  if (!range.any || !(std::max(-range.least, range.largest) > 0)) return {};
  auto plot = make_plot(kCircularDiagramWidth, kCircularDiagramHeight);
  auto& rect = *plot->axisRect();
  add_legend(*plot, circles, "W₂ > 0", "W₂ < 0");
  if (marks_unloading(subject)) add_legend_line(rect, line(kGreen, 1.4), unloading_name(subject));
  legend_below(*plot, 3);
  origin_below(*plot, subject);
  auto frame = frame_of(subject, 1);
  for (const double radius : {0.25, 0.5, 0.75})
    frame.circles.push_back({radius, fmt::format("{:g}", radius), line(kGridLine, 1), ""});
  draw_polar_frame(rect, frame);
  mark_unloading(rect, subject, frame.radius);
  draw_circles(rect, circles, [](double v) { return std::abs(v); });
  return {std::move(plot),
          fmt::format("Polar diagram of the normalised second-order work |W₂|/(|dσ| |dε|){}; the "
                      "rim is at 1. {}",
                      named(circles), simulated_with(subject))};
}

}  // namespace triax::src
