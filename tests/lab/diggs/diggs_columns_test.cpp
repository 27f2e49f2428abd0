// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/diggs/diggs_columns.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("find_diggs_column: our names and usual names of properties") {
  CHECK(find_diggs_column("cell_pressure", "")->quantity == Quantity::cell_pressure);
  CHECK(find_diggs_column("", "Axial Strain (%)")->quantity == Quantity::axial_strain);
  CHECK(find_diggs_column("unknown", "Deviator Stress")->quantity == Quantity::deviator_stress);
  CHECK(find_diggs_column("Total pore-water pressure", "u")->quantity == Quantity::pore_pressure);
  CHECK(find_diggs_column("", "Elapsed time [min]")->role == DiggsColumn::Role::time);
  CHECK_FALSE(find_diggs_column("temperature", "T"));
  CHECK_FALSE(find_diggs_column("", ""));
}

TEST_CASE("DiggsColumn: heading of the record") {
  CHECK(find_diggs_column("cell_pressure", "")->heading() == "cell_pressure_kPa");
  CHECK(find_diggs_column("time", "")->heading() == "time_s");
  CHECK(find_diggs_column("stage", "")->heading() == "stage");
}
