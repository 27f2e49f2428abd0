// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/paths/box_strain.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/grains/specimens.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

/// Undrained compression by `parts` increments at this pace; q at the end, Pa.
double sheared(double strain, int parts, double inertial_number) {
  Grains grains(calm_state());
  StrainPace pace;
  pace.inertial_number = inertial_number;
  const Vector<Axisymmetric> part{strain / parts, -strain / parts / std::numbers::sqrt2};
  for (int i = 0; i < parts; ++i)
    strain_box(grains, part, strain_steps(grains.state(), part.norm(), pace));
  return deviator_stress(axisymmetric_stress(grains.state()));
}

}  // namespace

TEST_CASE("The box is strained as asked, both radial axes alike, and its walls rest afterwards") {
  Grains grains(calm_state());
  const GrainBox before = grains.state().box;
  const Vector<Axisymmetric> strain{3e-5, -2e-5 * std::numbers::sqrt2};
  const StrainSteps steps = strain_steps(grains.state(), strain.norm(), {});
  const auto first = grains.state().steps;
  strain_box(grains, strain, steps);
  CHECK(grains.state().steps - first == steps.all());
  const auto made = natural_strain(before, grains.state().box);
  CHECK(made[kAxial] == Approx(3e-5).epsilon(1e-9));
  CHECK(made[0] == Approx(-2e-5).epsilon(1e-9));
  CHECK(made[1] == Approx(-2e-5).epsilon(1e-9));
  for (int a = 0; a < 3; ++a) {
    CHECK(grains.state().walls.drive[a].kind == AxisDrive::Kind::strain_rate);
    CHECK(grains.state().walls.strain_rate_per_s[a] == 0);
  }
}

TEST_CASE("Strain 0 takes no step") {
  Grains grains(calm_state());
  strain_box(grains, Vector<Axisymmetric>::Zero(), strain_steps(grains.state(), 0, {}));
  CHECK(grains.state() == calm_state());
}

TEST_CASE("A large increment takes steps by the bound of its rate, a tiny one hardly any") {
  const GrainState& s = calm_state();
  StrainPace pace;
  const auto crossing = crossing_steps(s);
  // A wave of √(E/5/ρ), about 200 m/s, through the box.
  CHECK(static_cast<double>(crossing) * s.time_step_s ==
        Approx(s.box.length_m(2) / 200).epsilon(0.2));
  const StrainSteps large = strain_steps(s, 1e-2, pace);
  CHECK(large.rise == crossing);
  pace.inertial_number *= 2;
  const StrainSteps faster = strain_steps(s, 1e-2, pace);
  CHECK(static_cast<double>(large.level + large.rise) ==
        Approx(2 * static_cast<double>(faster.level + faster.rise)).epsilon(1e-3));
  CHECK(strain_steps(s, 1e-6, pace).all() == 4 * crossing);
  CHECK(strain_steps(s, 1e-12, pace).all() == 4);
}

TEST_CASE("What the walls carry hardly depends on the pace or on how the strain is cut") {
  const double usual = sheared(4e-4, 4, 1e-4), start = sheared(0, 1, 1e-4);
  REQUIRE(usual - start > 3e3);
  CHECK(sheared(4e-4, 4, 3e-5) == Approx(usual).margin(0.1 * (usual - start)));
  CHECK(sheared(4e-4, 8, 1e-4) == Approx(usual).margin(0.1 * (usual - start)));
}
