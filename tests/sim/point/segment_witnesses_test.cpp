// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/segment_witnesses.hpp"

#include <catch2/catch.hpp>

#include "sim/materials/sanisand.hpp"
#include "tests/sim/materials/parameter_sets.hpp"
#include "tests/sim/point/triaxial_segment.hpp"

using namespace triax::sim;

namespace {

const Sanisand<Axisymmetric> kWitnessedSand{test::s28_general()};
const PointTolerance kTolerance{.relative = 1e-9};

PathInstant<Axisymmetric> start_of(const SegmentParts<Axisymmetric>& parts) {
  PathInstant<Axisymmetric> start;
  start.state = kWitnessedSand.start(isotropic<Axisymmetric>(100e3), 1.086);
  start.rate = parts.rate_at(start.state);
  return start;
}

}  // namespace

TEST_CASE("what happened within a part is found, isolated and in order") {
  auto segment = test::undrained_compression(0.02);
  segment.rows = segment.least_parts = 1;
  segment.end = {{.quantity = PathQuantity::axial_strain,
                  .component = 0,
                  .above = 0.015,
                  .below = {},
                  .label = "late"},
                 {.quantity = PathQuantity::mean_effective_stress,
                  .component = 0,
                  .above = {},
                  .below = 90e3,
                  .label = "early"}};
  const auto effective = effective_control(segment);
  const SegmentParts<Axisymmetric> parts(kWitnessedSand, segment, effective, kTolerance);
  SegmentWitnesses<Axisymmetric> witnesses(parts);
  const auto start = start_of(parts);
  CHECK(witnesses.at_start(start).empty());
  const auto end = parts.within(start, 1);
  REQUIRE(end);
  const auto found = witnesses.between(start, *end);
  // No peak of q: at the isotropic start q does not grow yet, and one part sees no more.
  REQUIRE(found.size() == 3);
  CHECK(found[0].what == "early");
  CHECK(found[0].at.state.p() == Approx(90e3).epsilon(1e-8));
  CHECK(found[1].kind == PathEventKind::second_order_work);
  CHECK(found[1].at.state.q() / 1e3 == Approx(37.21).margin(0.006));  // the undrained peak
  CHECK(found[2].what == "late");
  CHECK(found[2].at.strain(0) == Approx(0.015).epsilon(1e-9));
  CHECK(witnesses.work_is_negative());
  // What has been told is not told again.
  CHECK(witnesses.between(start, *end).empty());
}

TEST_CASE("an end condition that is met at the start is told there") {
  auto segment = test::undrained_compression(0.02);
  segment.end = {{.quantity = PathQuantity::mean_effective_stress,
                  .component = 0,
                  .above = {},
                  .below = 200e3,
                  .label = "met"}};
  const auto effective = effective_control(segment);
  const SegmentParts<Axisymmetric> parts(kWitnessedSand, segment, effective, kTolerance);
  SegmentWitnesses<Axisymmetric> witnesses(parts);
  const auto found = witnesses.at_start(start_of(parts));
  REQUIRE(found.size() == 1);
  CHECK(found[0].what == "met");
  CHECK_FALSE(witnesses.work_is_negative());
}
