// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/soil/figures/mohr_figure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/output/words.hpp"
#include "src/plot/mohr_circles.hpp"
#include "src/plot/note.hpp"
#include "src/soil/figures/trend_figure.hpp"

namespace triax::src {
namespace {

constexpr int kMohrWidth = 720, kMohrHeight = 440 + kNoteHeight;

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
  std::vector<DrawnCircle> circles;
  for (const auto& circle : set.circles)
    circles.push_back(
        {set.circles.size() <= 6 ? circle.name : "", circle.minor_kPa, circle.major_kPa});
  const double c = set.cohesion_kPa.value;
  draw_mohr_circles(*plot, circles, DrawnEnvelope{c, set.friction_angle_deg.value},
                    soil_note(soil));
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
