// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/soil/figures/mohr_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/output/words.hpp"
#include "src/plot/axes.hpp"
#include "src/plot/note.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/shapes.hpp"
#include "src/soil/figures/trend_figure.hpp"

namespace triax::src {
namespace {

constexpr int kMohrWidth = 720, kMohrHeight = 440 + kNoteHeight;

Points half_circle(const study::MohrCircle& circle) {
  const double middle = (circle.major_kPa + circle.minor_kPa) / 2;
  const double radius = (circle.major_kPa - circle.minor_kPa) / 2;
  Points points;
  for (int i = 0; i <= 90; ++i) {
    const double at = std::numbers::pi * i / 90;
    points.emplace_back(middle + radius * std::cos(at), radius * std::sin(at));
  }
  return points;
}

FigureData circles_data(const study::Soil& soil, const std::string& title) {
  FigureData data{.title = title,
                  .origin = std::ranges::all_of(soil.tests, &study::TestPoints::simulated)
                                ? "simulated"
                                : "recorded",
                  .remarks = {},
                  .columns = {{"test_id", ""}, {"minor_kPa", "kPa"}, {"major_kPa", "kPa"}},
                  .rows = {}};
  for (const auto& c : soil.strength->circles)
    data.rows.push_back({static_cast<double>(soil.tests[c.test].id), c.minor_kPa, c.major_kPa});
  return data;
}

}  // namespace

NamedFigure mohr_figure(const study::Soil& soil) {
  const auto& set = *soil.strength;
  auto plot = make_plot(kMohrWidth, kMohrHeight);
  auto& rect = *plot->axisRect();
  style_axes(rect, "effective normal stress σ′ (kPa)", "shear stress τ (kPa)");
  double most = 0, tallest = 0;
  std::size_t i = 0;
  for (const auto& circle : set.circles) {
    most = std::max(most, circle.major_kPa);
    tallest = std::max(tallest, (circle.major_kPa - circle.minor_kPa) / 2);
    draw_curve(rect, half_circle(circle), curve_pen(i++, 1.4),
               set.circles.size() <= 6 ? circle.name : "");
  }
  const double slope = std::tan(sim::radians(set.friction_angle_deg.value));
  const double c = set.cohesion_kPa.value;
  draw_curve(rect, {{0, c}, {most, c + most * slope}}, line(kInk, 2),
             fmt::format("c′ = {:.1f} kPa, φ′ = {:.1f}°", c, set.friction_angle_deg.value));
  legend_below(*plot, 3);
  note_below(*plot, soil_note(soil));
  set_equal_ranges(rect, QCPRange(std::min(0.0, c), 1.02 * most),
                   QCPRange(std::min(0.0, c), 1.15 * tallest));
  const std::string caption = fmt::format(
      "Mohr circles of {} specimens at {}, c′ = {:.1f} kPa ({:.1f} to {:.1f}), φ′ = {:.1f}° "
      "({:.1f} "
      "to {:.1f}).",
      set.circles.size(), spaced(std::string(to_string(set.criterion))), c, set.cohesion_kPa.low,
      set.cohesion_kPa.high, set.friction_angle_deg.value, set.friction_angle_deg.low,
      set.friction_angle_deg.high);
  return {"mohr_circles", {std::move(plot), caption}, circles_data(soil, caption)};
}

}  // namespace triax::src
