// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/paths/grain_shots.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/grains/law_of_grains.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

using Prepared = PreparedControl<Axisymmetric>;

/// The stiffness that the law found, as nothing but an elastic one.
SecantStiffness elastic(const GrainLaw& law) {
  SecantStiffness secant;
  secant.elastic = std::get<StiffnessForm<Axisymmetric>>(law.response(start_of(law))).stiffness;
  secant.going_on = secant.elastic;
  return secant;
}

Shot meet_from_start(const GrainLaw& law, const GrainControl& control, double fraction = 1) {
  const SecantStiffness secant = elastic(law);
  ShotLimits limits;
  limits.pace.least_pressure_pa = 5e3;
  return meet(grains_of(start_of(law)), secant, Prepared(control, secant.elastic(0, 0)), fraction,
              limits);
}

}  // namespace

TEST_CASE("Stresses asked for are met to the tolerance in a few shots") {
  const GrainLaw& law = *dense_grains();
  const Vector<Axisymmetric> wanted{600, 200};
  const Shot shot = meet_from_start(law, GrainControl::stresses(wanted));
  REQUIRE(shot.met);
  CHECK(shot.shots <= 3);
  CHECK((shot.stress - wanted).norm() <= 1 + 1e-9);
  CHECK((stress_of(shot.grains) - start_of(law).stress - shot.stress).norm() < 1e-9);
  CHECK(shot.strain.norm() > 1e-6);
  const Shot part = meet_from_start(law, GrainControl::stresses(wanted), 0.25);
  REQUIRE(part.met);
  CHECK((part.stress - 0.25 * wanted).norm() <= 1 + 1e-9);
}

TEST_CASE("Shots leave the state that they start from alone, and are the same each time") {
  const GrainLaw& law = *loose_grains();
  const GrainState before = grains_of(start_of(law));
  const auto control = undrained_load(300);
  const Shot a = meet_from_start(law, control), b = meet_from_start(law, control);
  CHECK(grains_of(start_of(law)) == before);
  CHECK(a.grains == b.grains);
  CHECK(a.strain == b.strain);
  CHECK_FALSE(a.grains == before);
}

TEST_CASE("A stress beyond what the grains carry is not met, and the strain says so") {
  const GrainLaw& law = *very_loose_grains();
  const Shot shot = meet_from_start(law, undrained_load(0.3 * law.pressure_pa()));
  CHECK_FALSE(shot.met);
  CHECK(shot.missed_pa > 0.1 * law.pressure_pa());
}
