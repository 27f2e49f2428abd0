// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/undrained_strength.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::lab;

namespace {

/// q = q(ε₁) every 0.5 % to the last strain.
template <class Q>
std::optional<UndrainedStrength> strength(const Q& q, double last_strain) {
  UndrainedStrengthFinder finder;
  for (int i = 0; 5e-3 * i <= last_strain + 1e-9; ++i) {
    State s;
    s.reading = i;
    s.strain.axial = 5e-3 * i;
    s.q = q(s.strain.axial);
    finder.add(s);
  }
  return finder.result(false);
}

double rising(double strain) { return 400e3 * strain; }
double peaked(double strain) { return 176e3 * (1 - std::pow(strain / 0.105 - 1, 2)); }

}  // namespace

TEST_CASE("UndrainedStrengthFinder: half of the peak of q") {
  const auto found = strength(peaked, 0.155);
  REQUIRE(found);
  CHECK(found->c_u_pa() == Approx(88e3));
  CHECK(*found->at.axial_strain == Approx(0.105));
  CHECK(found->peaked);
  CHECK_FALSE(found->at_15_pct);
  CHECK_FALSE(found->at.time_s);
  CHECK_FALSE(found->at.p_eff_pa);
}

TEST_CASE("UndrainedStrengthFinder: no peak, 15 % and 20 % axial strain") {
  const auto whole = strength(rising, 0.25);
  CHECK(*whole->at.axial_strain == Approx(0.20));
  CHECK(whole->c_u_pa() == Approx(40e3));
  CHECK(*whole->at_15_pct->axial_strain == Approx(0.15));
  CHECK_FALSE(whole->peaked);
  const auto brief = strength(rising, 0.10);
  CHECK(brief->c_u_pa() == Approx(20e3));
  CHECK_FALSE(brief->peaked);
  CHECK(brief->last_axial_strain == Approx(0.10));
  CHECK_FALSE(brief->at_15_pct);
}

TEST_CASE("UndrainedStrengthFinder: extension, a peak beyond 20 % and states without q") {
  const auto extension = strength([](double strain) { return -peaked(strain); }, 0.155);
  CHECK(extension->c_u_pa() == Approx(88e3));
  const auto late =
      strength([](double strain) { return strain > 0.22 ? 50e3 : rising(strain); }, 0.25);
  CHECK(*late->at.axial_strain == Approx(0.20));
  CHECK_FALSE(late->peaked);
  CHECK_FALSE(strength([](double) { return kMissing; }, 0.1));
  CHECK_FALSE(UndrainedStrengthFinder().result(true));
}
