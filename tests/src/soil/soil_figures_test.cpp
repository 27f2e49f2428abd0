// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/soil/soil_figures.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax;

namespace {

/// Six tests of which nothing but their critical states and circles is known.
study::Soil some_soil() {
  study::Soil soil;
  soil.group = "sand";
  study::Trend trend;
  for (std::size_t i = 0; i < 6; ++i) {
    study::TestPoints test{.id = static_cast<std::int64_t>(i) + 1, .name = "T" + std::to_string(i)};
    const double p = 50 * std::pow(2.0, i);
    test.void_ratio = 0.95;
    test.p_eff_kPa = p;
    test.critical.kind = study::CriticalKind::reached;
    test.critical.eta = study::measured(1.3, 0.01);
    test.critical.log_p = study::measured(std::log(p), 0.01);
    test.critical.void_ratio = study::measured(1 - 0.03 * std::log(p) + (i % 2 ? 0.004 : 0), 0.01);
    trend.points.push_back({std::log(p), test.critical.void_ratio->value, 0, 0.01});
    trend.tests.push_back(i);
    test.path = {{0.01, 0.5 * p, p, 0.95}, {0.2, 1.3 * p, p, test.critical.void_ratio->value}};
    test.end = test.path.back();
    soil.tests.push_back(test);
  }
  trend.line = *study::fit_line(trend.points);
  soil.critical_line = trend;
  soil.critical_power = study::fit_power_line(trend.points, 0.7);
  soil.critical_ratio =
      study::Level{*study::fit_mean({{0, 1.3, 0, 0.01}, {0, 1.31, 0, 0.01}}), {0, 1}};
  soil.strength =
      study::strength_set({{0, "T0", 350, 100}, {1, "T1", 652, 200}, {2, "T2", 1300, 400}}, {});
  return soil;
}

}  // namespace

TEST_CASE("A soil has the figures for which there is something to draw") {
  const auto figures = src::soil_figures(some_soil());
  REQUIRE(figures.size() == 3);
  CHECK(figures[0].name == "critical_state_line");
  CHECK(figures[0].data.rows.size() == 6);
  CHECK(figures[1].drawing.caption.find("M = 1.305") != std::string::npos);
  CHECK(figures[2].name == "mohr_circles");
  CHECK(src::to_svg(*figures[2].drawing.plot).find("c′ = ") != std::string::npos);
  CHECK(src::soil_figures({}).empty());
}

TEST_CASE("A trend names the tests that were left out as such") {
  auto soil = some_soil();
  soil.dilatancy_over_state = soil.critical_line;
  soil.dilatancy_over_state->odd_points.push_back({5, 2, 0, 0});
  soil.dilatancy_over_state->odd_tests.push_back(3);
  const auto figures = src::soil_figures(soil);
  REQUIRE(figures.size() == 4);
  CHECK(figures.back().data.rows.back() == std::vector<std::optional<double>>{5, 2, 1, 4});
}
