// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/column_plan.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;

TEST_CASE("headings come apart from their units") {
  CHECK(split_heading("Axial Strain (%)").name == "Axial Strain");
  CHECK(split_heading("Axial Strain (%)").unit == "%");
  CHECK(split_heading("Zeit [s]").unit == "s");
  CHECK_FALSE(split_heading("B Value").unit);
  CHECK_FALSE(split_heading("(%)").unit);
}

TEST_CASE("our own headings hold their unit behind _ or in brackets") {
  TableLayout layout;
  layout.dialect = find_dialect("triax");
  layout.heading_line = 1;
  std::vector<Warning> warnings;
  Findings findings(warnings);
  plan_columns(layout, "time_min,cell_pressure_psi,axial_strain (%),Pore_Pressure [MPa],x (kPa)",
               {}, findings);
  REQUIRE(layout.columns.size() == 4);
  CHECK(layout.columns[0].scale == 60);
  CHECK(layout.columns[1].scale == Approx(6894.757));
  CHECK(layout.columns[2].quantity == Quantity::axial_strain);
  CHECK(layout.columns[2].scale == 0.01);
  CHECK(layout.columns[3].quantity == Quantity::pore_pressure);
  CHECK(layout.columns[3].scale == 1e6);
  CHECK(warnings.size() == 1);
}

TEST_CASE("the first synonym of a dialect wins, wherever it stands") {
  TableLayout layout;
  layout.dialect = parse_dialect(
      "name = \"d\"\n[columns]\npore_pressure = [\"Mid Plane PWP\", \"Pore Pressure\"]\n", "d");
  layout.heading_line = 1;
  std::vector<Warning> warnings;
  Findings findings(warnings);
  plan_columns(layout, "Pore Pressure (kPa),Mid Plane PWP (MPa),", {}, findings);
  CHECK(layout.cell_count == 2);
  REQUIRE(layout.columns.size() == 1);
  CHECK(layout.columns[0].cell == 1);
  CHECK(layout.columns[0].scale == 1e6);
  CHECK(count_known(layout.dialect, {"PORE pressure (kPa)", "12.5", "other"}) == 1);
  TableLayout twice;
  twice.dialect = layout.dialect;
  CHECK_THROWS_AS(plan_columns(twice, "Pore Pressure (kPa),Pore Pressure (bar)", {}, findings),
                  BadInput);
}
