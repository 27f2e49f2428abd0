// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/segment_parts.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "sim/materials/sanisand.hpp"
#include "tests/sim/materials/parameter_sets.hpp"
#include "tests/sim/point/triaxial_segment.hpp"

using namespace triax::sim;

namespace {

struct Case {
  Sanisand<Axisymmetric> law{test::s28_general()};
  Segment<Axisymmetric> segment;
  EffectiveControl<Axisymmetric> effective;
  PointTolerance tolerance{.relative = 1e-9};
  PathInstant<Axisymmetric> start;

  explicit Case(const Segment<Axisymmetric>& asked)
      : segment(asked), effective(effective_control(segment)) {
    start.state = law.start(isotropic<Axisymmetric>(100e3), 1.0);
    start.pore_pressure = 50e3;
  }
  SegmentParts<Axisymmetric> parts() const { return {law, segment, effective, tolerance}; }
};

}  // namespace

TEST_CASE("parts are as many to each row, and a share of one leads where the whole comes by") {
  Case undrained(test::undrained_compression(0.01));
  undrained.segment.rows = 30;
  undrained.segment.least_parts = 40;
  const auto parts = undrained.parts();
  CHECK(parts.count() == 60);
  const auto half = parts.within(undrained.start, 0.5);
  REQUIRE(half);
  CHECK(half->strain(0) == Approx(0.5 * 0.01 / 60));
  CHECK(half->progress == Approx(0.5 / 60));
  // At constant cell pressure the pore pressure is what the radial effective stress lost.
  const double lost = undrained.start.state.stress(1) - half->state.stress(1);
  CHECK(half->pore_pressure - 50e3 == Approx(lost / std::numbers::sqrt2));
  CHECK(half->rate.controllable);
  CHECK(parts.total_stress_rate(half->rate)(1) == Approx(0).margin(1e-6));

  const auto whole = parts.within(undrained.start, 1);
  const auto rest = parts.within(*half, 0.5);
  REQUIRE((whole && rest));
  CHECK((whole->state.stress - rest->state.stress).norm() < 1e-6 * 100e3);
}

TEST_CASE("a total stress that the pore water takes moves nothing but the pore pressure") {
  Case raised(test::undrained_compression(0));
  raised.segment.conditions.increment << 0, 60e3;  // of the cell pressure
  raised.effective = effective_control(raised.segment);
  const auto parts = raised.parts();
  REQUIRE(parts.stands_still());
  const auto after = parts.within(raised.start, 0.25);
  REQUIRE(after);
  CHECK(after->pore_pressure == Approx(50e3 + 0.25 * 60e3 / parts.count()));
  CHECK(after->state.stress == raised.start.state.stress);
  CHECK_FALSE(after->rate.controllable);
}

TEST_CASE("what the law cannot follow has no instant, and an objection no rate") {
  const Case torn(test::undrained_compression(0.01));
  auto nothing = torn.start.state;
  nothing.stress.setZero();
  CHECK_FALSE(torn.parts().rate_at(nothing).controllable);
  CHECK_FALSE(torn.parts().within({.state = nothing}, 1));
}
