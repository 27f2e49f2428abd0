// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/reference/reference_json.hpp"

#include <catch2/catch.hpp>

using namespace triax;

TEST_CASE("reference results as JSON: units in names, null for what is unknown") {
  lab::AgsResults file;
  file.file = "x.ags";
  file.edition = "4.1";
  lab::ReferenceResult& r = file.results.emplace_back();
  r.group = "TRET";
  r.test_type = "CIDC";
  r.cell_pressure_pa = 500e3;
  r.pore_pressure_pa = 300e3;
  r.q_pa = 150.3e3;
  r.axial_strain = 0.113;
  r.initial_water_content = 47 * 0.01;  // as it is read
  r.bulk_density_kg_m3 = 1650;
  const study::Json d = src::reference_json(file);
  CHECK(d["source"] == "x.ags");
  CHECK(d["readings"] == 0);
  CHECK(d["edition"] == "4.1");
  CHECK(d["project"].is_null());
  const study::Json& one = d["reference_results"].at(0);
  CHECK(one["at_failure"]["q_kPa"].dump() == "150.3");
  CHECK(one["at_failure"]["p_eff_kPa"].get<double>() == Approx(250.1));
  CHECK(one["at_failure"]["axial_strain_pct"].dump() == "11.3");
  CHECK(one["specimen"]["bulk_density_Mg_m3"].dump() == "1.65");
  CHECK(one["specimen"]["initial_water_content_pct"].dump() == "47.0");
  CHECK(one["specimen"]["location"].is_null());
  CHECK(one["cohesion_kPa"].is_null());
  CHECK(d["warnings"].empty());
}
