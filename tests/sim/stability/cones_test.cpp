// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/cones.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "tests/sim/stability/stability_states.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

/// A made-up answer with a given normalised work.
Prober made_up(
    std::function<double(double degrees)> work,
    std::function<bool(double degrees)> answered = [](double) { return true; }) {
  return [work = std::move(work), answered = std::move(answered)](double angle) {
    Probe probe{angle, answered(degrees(angle))};
    probe.normalised = probe.answered ? work(degrees(angle)) : 0;
    return probe;
  };
}

/// Distance of two directions, at most 180.
double apart(double a_deg, double b_deg) { return std::abs(std::remainder(a_deg - b_deg, 360)); }

/// Below zero within `half` degrees of any of these directions.
Prober with_cones(std::vector<double> middles, double half) {
  return made_up([=](double at) {
    double least = 1e9;
    for (const double middle : middles) least = std::min(least, apart(at, middle) / half - 1);
    return std::min(least / 100, 0.5);
  });
}

struct Printed {
  double p_kPa, eta, e;
  double first_deg, last_deg;  // on a grid of half degrees; both 0: no cone
};

/// The first and the last direction of a grid of half degrees that lie in the cone.
void check_printed(const Law<Axisymmetric>& law, const std::vector<Printed>& printed) {
  for (const auto& row : printed) {
    INFO("p = " << row.p_kPa << " kPa, eta = " << row.eta << ", e = " << row.e);
    const Circle circle = circle_at(law, row.p_kPa, row.eta, row.e);
    if (row.last_deg == 0) {
      CHECK(circle.cones.empty());
      CHECK(circle.least.normalised > 0);
      continue;
    }
    REQUIRE(circle.cones.size() == 1);
    const Cone& cone = circle.cones.front();
    CHECK(std::ceil(2 * degrees(cone.from)) / 2 == row.first_deg);
    CHECK(std::floor(2 * degrees(cone.to)) / 2 == row.last_deg);
    CHECK(circle.least.normalised < 0);
    CHECK(cone.contains(circle.least.angle));
    CHECK(cone.strongest.angle == circle.least.angle);
  }
}

}  // namespace

TEST_CASE("cones of INL2 and octolinear as constitutive.md prints them on half degrees") {
  check_printed(inl2(), {{70, 0.30, 1.086, 0, 0},
                         {70, 0.55, 1.086, 0, 0},
                         {70, 0.60, 1.086, 215, 237.5},
                         {70, 0.70, 1.086, 208, 248.5},
                         {70, 0.80, 1.086, 205.5, 255.5},
                         {100, 0.65, 0.75, 0, 0},
                         {100, 0.70, 0.75, 225, 241.5},
                         {100, 1.00, 0.75, 218.5, 260.5}});
  check_printed(octo(), {{70, 0.55, 1.086, 223.5, 233},
                         {70, 0.60, 1.086, 215.5, 243},
                         {70, 0.70, 1.086, 209, 252.5}});
}

TEST_CASE("edges are where the work vanishes, and do not depend on the steps") {
  const auto law = inl2();
  const auto prober =
      make_prober(response_at<Axisymmetric>(law, 70, 0.6, 1.086), ProbeKind::stress);
  const Circle coarse = probe_circle(prober, {.directions = 36});
  const Circle fine = probe_circle(prober, {.directions = 720});
  REQUIRE((coarse.cones.size() == 1 && fine.cones.size() == 1));
  for (const double edge : {coarse.cones[0].from, coarse.cones[0].to})
    CHECK(std::abs(prober(edge).normalised) < 1e-9);
  CHECK(coarse.cones[0].from == Approx(fine.cones[0].from).margin(1e-9));
  CHECK(coarse.cones[0].to == Approx(fine.cones[0].to).margin(1e-9));
  CHECK(coarse.least.normalised == Approx(fine.least.normalised).margin(1e-12));
  CHECK(std::ranges::is_sorted(coarse.probes, {}, &Probe::angle));
  CHECK(coarse.probes.size() > 36);
}

TEST_CASE("a cone narrower than a step is found by its minimum") {
  // Between the steps at 220 and 230 degrees both of which are stable.
  const Circle circle = probe_circle(with_cones({226.3}, 0.4), {.directions = 36});
  REQUIRE(circle.cones.size() == 1);
  CHECK(degrees(circle.cones[0].from) == Approx(225.9).margin(1e-6));
  CHECK(degrees(circle.cones[0].to) == Approx(226.7).margin(1e-6));
  CHECK(degrees(circle.least.angle) == Approx(226.3).margin(1e-4));
}

TEST_CASE("a gap narrower than a step parts a cone in two") {
  // 189 to 259 but for 0.8 degrees around 226.7, between the steps at 220 and 230.
  const auto prober = made_up([](double at) {
    const double from_gap = apart(at, 226.7);
    return apart(at, 224) < 35 && from_gap > 0.4 ? -0.01 * from_gap : 0.1;
  });
  const Circle circle = probe_circle(prober, {.directions = 36});
  REQUIRE(circle.cones.size() == 2);
  CHECK(degrees(circle.cones[0].from) == Approx(189).margin(1e-6));
  CHECK(degrees(circle.cones[0].to) == Approx(226.3).margin(1e-6));
  CHECK(degrees(circle.cones[1].from) == Approx(227.1).margin(1e-6));
  CHECK(degrees(circle.cones[1].to) == Approx(259).margin(1e-6));
}

TEST_CASE("two cones, one of them across alpha = 0") {
  const Circle circle = probe_circle(with_cones({2, 226}, 12), {.directions = 36});
  REQUIRE(circle.cones.size() == 2);
  CHECK(degrees(circle.cones[0].from) == Approx(214).margin(1e-6));
  CHECK(degrees(circle.cones[0].to) == Approx(238).margin(1e-6));
  CHECK(degrees(circle.cones[1].from) == Approx(350).margin(1e-6));
  CHECK(degrees(circle.cones[1].to) == Approx(374).margin(1e-6));
  CHECK(circle.cones[1].contains(radians(5)));
  CHECK(circle.cones[1].contains(radians(-5)));
  CHECK_FALSE(circle.cones[1].contains(radians(180)));
}

TEST_CASE("unanswered directions bound a cone and are counted") {
  const auto circle =
      probe_circle(made_up([](double at) { return apart(at, 90) < 60 ? -0.1 : 0.3; },
                           [](double at) { return apart(at, 120) > 33; }),
                   {.directions = 36});
  REQUIRE(circle.cones.size() == 1);  // 30 to 150 without 87 to 153
  CHECK(degrees(circle.cones[0].from) == Approx(30).margin(1e-6));
  CHECK(degrees(circle.cones[0].to) == Approx(87).margin(1e-6));
  CHECK(circle.unanswered == 7);  // 90, 100 ... 150
}

TEST_CASE("all directions unstable, and none answered") {
  const Circle all =
      probe_circle(made_up([](double at) { return -0.2 - 0.1 * std::cos(radians(at)); }));
  REQUIRE(all.cones.size() == 1);
  CHECK(all.cones[0].opening() == Approx(2 * std::numbers::pi));
  CHECK(all.least.normalised == Approx(-0.3));
  const Circle none = probe_circle(made_up([](double) { return 1; }, [](double) { return false; }));
  CHECK(none.cones.empty());
  CHECK_FALSE(none.least.answered);
  CHECK(none.unanswered == 36);
}

TEST_CASE("round-off below zero is no instability; probes are left out where nobody wants them") {
  const Circle circle =
      probe_circle(made_up([](double) { return -1e-14; }), {.keep_probes = false});
  CHECK(circle.cones.empty());
  CHECK(circle.probes.empty());
  CHECK_THROWS_AS(probe_circle(made_up([](double) { return 1; }), {.directions = 7}),
                  std::invalid_argument);
}

TEST_CASE("isotropic unloading enters the cone where undrained q peaks: 215.26 degrees") {
  // η of the ICU peak and of CSD collapse at this state, by dε_v = 0 under dq = 0.
  const auto law = inl2();
  const auto swells = [&](double eta) {
    const auto rate =
        response_at<Axisymmetric>(law, 70, eta, 1.086)->to_stress(-identity<Axisymmetric>());
    return trace<Axisymmetric>(rate.strain) < 0;
  };
  double low = 0.5, high = 0.7;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (swells(middle) ? low : high) = middle;
  }
  CHECK(low == Approx(0.596).margin(0.002));
  const auto holds = [&](double eta) {
    const Circle circle = circle_at(law, 70, eta, 1.086);
    return std::ranges::any_of(circle.cones,
                               [](const Cone& c) { return c.contains(kIsotropicUnloading); });
  };
  CHECK_FALSE(holds(low - 1e-6));
  CHECK(holds(low + 1e-6));
}
