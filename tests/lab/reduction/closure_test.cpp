// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/closure.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {
/// A closure fed with a file's q that is `share` of ours, on `area` of our 4000 mm².
Closure fed(double share, double area, bool in_shear = true) {
  Closure closure;
  for (int i = 1; i < 10; ++i) {
    State state;
    state.q = 10e3 * i;
    state.area_m2 = 4e-3;
    Reading reading;
    reading[Quantity::deviator_stress] = share * state.q;
    reading[Quantity::current_area] = area * state.area_m2;
    closure.add(reading, state, in_shear);
  }
  return closure;
}
}  // namespace

namespace {
Check q_check(const Closure& closure, bool joined = false) {
  const auto checks = closure.checks(4e-3, joined);
  REQUIRE(checks.size() == 2);  // q and the area
  REQUIRE(checks[0].kind == CheckKind::closure_deviator_stress);
  return checks[0];
}
}  // namespace

TEST_CASE("the difference of q is ours less theirs, over ours") {
  const Check lower = q_check(fed(0.99, 1));
  CHECK(*lower.measured == Approx(0.01));
  CHECK(lower.ok);
  CHECK(lower.note == "the q in the file is 1.00 % lower than the value of triax");
  CHECK_FALSE(q_check(fed(1.05, 1)).ok);
}

TEST_CASE("the area is named only where it explains the difference") {
  const Check explained = q_check(fed(1 / 0.95, 0.95));
  CHECK(explained.note.find("3800.0 mm2, triax 4000.0 mm2") != std::string::npos);
  CHECK(explained.note.find("counter") == std::string::npos);
  const Check counted = q_check(fed(1 / 0.95, 0.95), true);
  CHECK(counted.note.find("counter was reset") != std::string::npos);
  CHECK(q_check(fed(1 / 0.95, 1)).note.find("area") == std::string::npos);
}

TEST_CASE("every computed column is compared") {
  Closure closure;
  for (int i = 1; i < 10; ++i) {
    State state;
    state.p_eff = 100e3;
    state.strain.axial = 1e-3 * i;
    Reading reading;
    reading[Quantity::mean_effective_stress] = 101e3;
    reading[Quantity::axial_strain] = 1.1e-3 * i;
    closure.add(reading, state, true);
  }
  const auto checks = closure.checks({}, false);
  REQUIRE(checks.size() == 2);
  CHECK(checks[0].kind == CheckKind::closure_mean_effective_stress);
  CHECK(checks[0].ok);
  CHECK(checks[1].kind == CheckKind::closure_axial_strain);
  CHECK(*checks[1].measured == Approx(-0.1));
}

TEST_CASE("nothing to compare is no check") {
  CHECK(Closure().checks(4e-3, false).empty());
  CHECK(fed(1, 1, false).checks(4e-3, false).empty());
}
