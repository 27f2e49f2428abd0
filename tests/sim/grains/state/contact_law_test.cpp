// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/contact_law.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

using namespace triax::sim;

TEST_CASE("Grains: stiffness in series is what yade computes for the paper's value") {
  const ContactLaw law;
  CHECK(normal_stiffness(law, 1e-3, 1e-3) == Approx(356000));
  CHECK(normal_stiffness(law, 1e-3, 4.75e-3) == Approx(588174).epsilon(1e-6));
  CHECK(normal_stiffness(law, 4.75e-3, 1e-3) == normal_stiffness(law, 1e-3, 4.75e-3));
  CHECK(wall_stiffness(law, 1e-3) == Approx(356000));
}

TEST_CASE("Grains: the literal reading gives k_n = E D for equal spheres, twice the other") {
  ContactLaw law;
  law.reading = StiffnessReading::literal;
  CHECK(normal_stiffness(law, 2e-3, 2e-3) == Approx(law.stiffness_over_diameter_pa * 4e-3));
  CHECK(normal_stiffness(law, 1e-3, 3e-3) ==
        Approx(2 * normal_stiffness(ContactLaw{}, 1e-3, 3e-3)));
}

TEST_CASE("Grains: the default friction angle is the paper's 35 degrees") {
  CHECK(friction_coefficient(ContactLaw{}) == Approx(0.700207538));
}

TEST_CASE("Grains: a contact law out of its range is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](auto change) {
    ContactLaw law;
    change(law);
    CHECK_THROWS_AS(check(law), std::invalid_argument);
  };
  CHECK_NOTHROW(check(ContactLaw{}));
  refused([](ContactLaw& l) { l.stiffness_over_diameter_pa = 0; });
  refused([](ContactLaw& l) { l.tangential_ratio = -0.1; });
  refused([](ContactLaw& l) { l.friction_angle = 1.6; });
  refused([](ContactLaw& l) { l.density_kg_per_m3 = -1; });
  refused([](ContactLaw& l) { l.damping = 1; });
  refused([nan](ContactLaw& l) { l.damping = nan; });
  refused([nan](ContactLaw& l) { l.tangential_ratio = nan; });
}
