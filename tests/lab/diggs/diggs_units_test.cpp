// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/diggs/diggs_units.hpp"

#include <catch2/catch.hpp>

using namespace triax;

TEST_CASE("find_diggs_unit: symbols of the Energistics dictionary") {
  CHECK(lab::find_diggs_unit("kPa")->scale == 1e3);
  CHECK(lab::find_diggs_unit("lbf/in2")->scale == 6894.757293168);
  CHECK(lab::find_diggs_unit("lbf/ft2")->scale == Approx(47.88026).epsilon(1e-6));
  CHECK(lab::find_diggs_unit("tonfUS/ft2")->scale == Approx(95760.52).epsilon(1e-6));
  CHECK(lab::find_diggs_unit(" ft ")->scale == 0.3048);
  CHECK(lab::find_diggs_unit("Euc")->dimension == sim::Dimension::none);
  CHECK(lab::find_diggs_unit("")->scale == 1);
  CHECK_FALSE(lab::find_diggs_unit("furlong"));
}
