// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/grains/grain_rose_findings.hpp"

#include <catch2/catch.hpp>

#include "tests/src/sample_grains.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::study;

namespace {

void check_range(const std::vector<AngleRange>& ranges, double from_deg, double to_deg, int count) {
  REQUIRE(ranges.size() == 1);
  CHECK(sim::degrees(ranges[0].from) == Approx(from_deg).margin(1e-9));
  CHECK(sim::degrees(ranges[0].to) == Approx(to_deg).margin(1e-9));
  CHECK(ranges[0].directions == count);
}

}  // namespace

TEST_CASE("the ranges of a rose are those that it was made with") {
  const auto found = rose_findings(test::rose());
  CHECK(found.made == 36);
  CHECK(found.at_rest == 35);
  check_range(found.negative, 220, 230, 2);
  check_range(found.agreeing, 230, 420, 20);  // through 0° to 60°
  check_range(found.irreversible, 50, 260, 22);
  check_range(found.dynamic, 80, 210, 14);
  check_range(found.not_at_rest, 140, 140, 1);
  CHECK(found.most_kinetic_j == 1e-6);
  CHECK(*found.least_normalised == Approx(-0.2));
  CHECK(sim::degrees(*found.least_angle) == Approx(220));
}

TEST_CASE("the null probe is measured by the smallest probe") {
  auto rose = test::rose();
  // Every strain has the norm 1e-5 in the Rendulic plane.
  auto found = rose_findings(rose);
  CHECK(*found.smallest_strain == Approx(1e-5));
  CHECK(*found.drift == Approx(1e-3));
  CHECK_FALSE(found.drifts());
  rose.null_probe.strain = {0, 2e-6};  // √2 · 2e-6
  found = rose_findings(rose);
  CHECK(*found.drift == Approx(0.2 * std::numbers::sqrt2));
  CHECK(found.drifts());
  rose.null_probe.stopped = true;
  CHECK_FALSE(rose_findings(rose).drift);
}

TEST_CASE("contacts that the null probe finds at their limit too do not count as irreversible") {
  auto rose = test::rose();
  rose.null_probe.sliding_share = 0.045;
  CHECK(rose_findings(rose).irreversible.empty());
  rose.null_probe.sliding_share = 0.035;
  check_range(rose_findings(rose).irreversible, 50, 260, 22);
}

TEST_CASE("a range ends where directions were not probed, and all around is one range") {
  std::vector<sim::GrainProbe> probes;
  for (const double degrees : {0.0, 10.0, 20.0, 180.0, 190.0})
    probes.push_back(test::probe_at(degrees, 1));
  const auto any = [](const sim::GrainProbe&) { return true; };
  auto ranges = ranges_where(probes, any);
  REQUIRE(ranges.size() == 2);
  CHECK(sim::degrees(ranges[0].to) == Approx(20));
  CHECK(sim::degrees(ranges[1].from) == Approx(180));
  check_range(ranges_where(test::rose().probes, any), 0, 350, 36);
  CHECK(ranges_where({}, any).empty());
}

TEST_CASE("stopped probes are left out, also where they would have been in a range") {
  auto rose = test::rose();
  rose.probes[23].stopped = true;  // 230°
  const auto found = rose_findings(rose);
  CHECK(found.made == 35);
  check_range(found.negative, 220, 220, 1);
  for (auto& probe : rose.probes) probe.stopped = true;
  const auto nothing = rose_findings(rose);
  CHECK(nothing.made == 0);
  CHECK(nothing.negative.empty());
  CHECK_FALSE(nothing.smallest_strain);
}

TEST_CASE("micro over macro is the ratio of Eqs. (11) and (7); without work there is none") {
  CHECK(*micro_over_macro(test::probe_at(90, 0.02, 1.1)) == Approx(1.1));
  CHECK_FALSE(micro_over_macro(test::probe_at(90, 0)));
}

TEST_CASE(
    "of the gap between micro- and macroscopic work what is explained is told, and what not") {
  auto rose = test::rose();
  auto found = rose_findings(rose);
  // 99 % of each gap is explained, 90 % by grains; two gaps are negative.
  CHECK(*found.gap_left == Approx(0.01));
  CHECK(*found.gap_of_grains > 0.8);
  CHECK(*found.gap_of_grains < 0.9);
  CHECK(*found.max_boundary_term == Approx(0.03));
  CHECK(*found.max_energy_error == Approx(0.005));
  rose.probes[3].work.grains_turning = std::nan("");
  found = rose_findings(rose);
  CHECK_FALSE(found.gap_left);
  CHECK_FALSE(found.gap_of_grains);
}

TEST_CASE("a circle of strain probes has the strains that were asked for, and stresses answer") {
  auto rose = test::rose();
  const sim::Circle by_strain = circle_of(rose, sim::ProbeKind::strain, 2e-5);
  CHECK(by_strain.probes[9].strain.y() == Approx(2e-5));
  CHECK(by_strain.probes[9].stress.y() == Approx(1000));
  CHECK(by_strain.probes[0].stress.x() == Approx(1000));
  CHECK(by_strain.probes[9].normalised == Approx(0.01 / (2e-5 * 1000)));
  const sim::Circle by_stress = circle_of(rose, sim::ProbeKind::stress, 500);
  CHECK(by_stress.probes[9].stress.y() == Approx(500));
  CHECK(by_stress.probes[9].strain.y() == Approx(1e-5));
}
