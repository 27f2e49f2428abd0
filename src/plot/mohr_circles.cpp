// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/mohr_circles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/plot/axes.hpp"
#include "src/plot/note.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/shapes.hpp"

namespace triax::src {
namespace {

Points half_circle(const DrawnCircle& circle) {
  const double middle = (circle.major_kPa + circle.minor_kPa) / 2;
  const double radius = (circle.major_kPa - circle.minor_kPa) / 2;
  Points points;
  for (int i = 0; i <= 90; ++i) {
    const double at = std::numbers::pi * i / 90;
    points.emplace_back(middle + radius * std::cos(at), radius * std::sin(at));
  }
  return points;
}

}  // namespace

void draw_mohr_circles(QCustomPlot& plot, const std::vector<DrawnCircle>& circles,
                       const std::optional<DrawnEnvelope>& envelope, const std::string& note) {
  auto& rect = *plot.axisRect();
  style_axes(rect, "effective normal stress σ′ (kPa)", "shear stress τ (kPa)");
  bool named = envelope.has_value();
  double most = 0;
  std::size_t i = 0;
  constexpr std::size_t kMostPens = 24;
  for (const auto& circle : circles) {
    most = std::max(most, circle.major_kPa);
    const auto pen =
        circles.size() > kMostPens ? line(QColor(0, 0x72, 0xB2, 70), 1) : curve_pen(i++, 1.4);
    draw_curve(rect, half_circle(circle), pen, circle.name);
    named = named || !circle.name.empty();
  }
  if (envelope) {
    const double slope = std::tan(envelope->friction_angle_deg * std::numbers::pi / 180);
    const double c = envelope->cohesion_kPa;
    draw_curve(rect, {{0, c}, {most, c + most * slope}}, line(kInk, 2),
               envelope->name.empty()
                   ? fmt::format("c′ = {:.1f} kPa, φ′ = {:.1f}°", c, envelope->friction_angle_deg)
                   : envelope->name);
  }
  if (named) legend_below(plot, 3);
  note_below(plot, note);
  scale_mohr_circles(plot, circles, envelope);
}

void scale_mohr_circles(QCustomPlot& plot, const std::vector<DrawnCircle>& circles,
                        const std::optional<DrawnEnvelope>& envelope) {
  double most = 0, left = 0, tallest = 0;
  for (const auto& circle : circles) {
    most = std::max(most, circle.major_kPa);
    left = std::min(left, circle.minor_kPa);
    tallest = std::max(tallest, (circle.major_kPa - circle.minor_kPa) / 2);
  }
  const double bottom = std::min(0.0, envelope ? envelope->cohesion_kPa : 0);
  set_equal_ranges(*plot.axisRect(), QCPRange(left, 1.06 * most), QCPRange(bottom, 1.15 * tallest));
  // What one of the axes has to spare lies beyond the circles, not before them.
  plot.xAxis->setRange(left, left + plot.xAxis->range().size());
  plot.yAxis->setRange(bottom, bottom + plot.yAxis->range().size());
}

}  // namespace triax::src
