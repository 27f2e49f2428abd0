// SPDX-License-Identifier: GPL-3.0-or-later
// Values around the circle: signs, zero crossings, gaps.
#include "src/plot/directions.hpp"

#include <catch2/catch.hpp>

#include "tests/src/probe/sample_circles.hpp"

using namespace triax;
using namespace triax::src;

namespace {
double normalised(const sim::Probe& probe) { return probe.normalised; }
}  // namespace

TEST_CASE("runs change where the straight line between two probes is zero, and close the circle") {
  const auto circle = test::invented_circle([](double a) { return std::cos(a); });
  const auto runs = signed_runs(circle.probes, normalised, sim::radians(1));
  REQUIRE(runs.size() == 3);
  CHECK_FALSE(runs[0].negative);
  CHECK(runs[1].negative);
  CHECK_FALSE(runs[2].negative);
  CHECK(runs[1].points.front().angle == Approx(sim::radians(90)).margin(1e-9));
  CHECK(runs[1].points.back().angle == Approx(sim::radians(270)).margin(1e-9));
  CHECK(runs[2].points.back().angle == Approx(2 * std::numbers::pi));
  CHECK(runs[2].points.back().value == 1);
  for (const auto& run : runs)
    for (std::size_t i = 1; i < run.points.size(); ++i) {
      const double step = run.points[i].angle - run.points[i - 1].angle;
      CHECK(step >= 0);
      CHECK(step <= sim::radians(1) * (1 + 1e-9));
    }
}

TEST_CASE("a sign change between two steps lies where the line crosses zero") {
  auto circle = test::invented_circle([](double) { return 0.5; });
  circle.probes[5].normalised = -0.25;
  const auto runs = signed_runs(circle.probes, normalised, 1);
  REQUIRE(runs.size() == 3);
  CHECK(runs[1].points.front().angle == Approx(sim::radians(40 + 10 * 2.0 / 3)));
  CHECK(runs[1].points.back().angle == Approx(sim::radians(50 + 10 / 3.0)));
}

TEST_CASE("directions without an answer leave a gap; the edges of a cone are zero of both sides") {
  auto circle = test::invented_circle([](double) { return 1.0; });
  circle.probes[18].answered = false;
  auto runs = signed_runs(circle.probes, normalised, 1);
  REQUIRE(runs.size() == 2);
  CHECK(runs[0].points.back().angle == Approx(sim::radians(170)));
  CHECK(runs[1].points.front().angle == Approx(sim::radians(190)));
  circle = test::inl2_circle(0.6);
  runs = signed_runs(circle.probes, normalised, 1);
  REQUIRE(runs.size() == 3);
  CHECK(runs[1].points.front().angle == Approx(circle.cones[0].from).margin(1e-7));
  CHECK(runs[1].points.back().angle == Approx(circle.cones[0].to).margin(1e-7));
  CHECK(signed_runs({}, normalised, 1).empty());
}
