// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mechanics/units.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace triax::sim;

TEST_CASE("usual spellings of a unit are one unit") {
  CHECK(find_unit("kN/m2")->scale == 1e3);
  CHECK(find_unit("mm³")->scale == find_unit("mm^3")->scale);
  CHECK(find_unit("kgf/cm2")->scale == Approx(98066.5));
  CHECK(find_unit("%")->scale == 0.01);
  CHECK(find_unit("Mg/m3")->scale == find_unit("kg/m3")->scale * 1000);
  CHECK(find_unit("psi")->scale == Approx(6894.757).epsilon(1e-6));
  CHECK_FALSE(find_unit("KPA"));
  CHECK_FALSE(find_unit("furlong"));
}

TEST_CASE("a decimal of the field goes to SI and back to the same text") {
  CHECK(to_field(to_si(500.12, *find_unit("kPa")), *find_unit("kPa")) == 500.12);
  CHECK(to_field(to_si(0.0001, *find_unit("mm")), *find_unit("mm")) == 0.0001);
}

TEST_CASE("to_field is the exact inverse of to_si for every value of the field") {
  std::mt19937_64 rng(3);
  std::uniform_real_distribution<double> exponent(-6, 6), digits(-1, 1);
  for (const char* name : {"kPa", "mm", "mm3", "kN", "mm2", "deg", "%", "psi", "min"}) {
    const Unit unit = *find_unit(name);
    for (int i = 0; i < 2000; ++i) {
      const double si = to_si(digits(rng) * std::pow(10, exponent(rng)), unit);
      CHECK(to_si(to_field(si, unit), unit) == si);
    }
  }
}
