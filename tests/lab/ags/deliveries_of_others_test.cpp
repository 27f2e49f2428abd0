// SPDX-License-Identifier: GPL-3.0-or-later
// A real delivery, in the folder that TRIAX_RECORDS_OF_OTHERS names; it is not ours to copy.
// Without that variable triaxial_results_test.cpp stands for it.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "lab/ags/ags_reader.hpp"
#include "lab/ags/triaxial_results.hpp"

using namespace triax::lab;

TEST_CASE("a delivery of 45 groups, Windows-1252: one drained test", "[of-others]") {
  const char* folder = std::getenv("TRIAX_RECORDS_OF_OTHERS");
  if (!folder || !*folder) {
    std::cout << "skipped: TRIAX_RECORDS_OF_OTHERS names no folder with ags/541241c_v2.ags\n";
    return;
  }
  const auto path = std::filesystem::path(folder) / "ags/541241c_v2.ags";
  const auto source = open_file(path.string());
  REQUIRE(looks_like_ags(*source));
  const AgsResults all = read_triaxial_results(*source);
  CHECK(all.edition == "4");
  REQUIRE(all.results.size() == 1);
  const ReferenceResult& r = all.results[0];
  CHECK(r.group == "TRET");
  CHECK(r.specimen == ReferenceSpecimen{"BH102", "22", "U", "", "B1[1]", 4.55, 4.68});
  CHECK(r.test_type == "CD");
  CHECK(r.condition.empty());
  CHECK(*r.diameter_m * 1e3 == Approx(64.75));
  CHECK(*r.height_m * 1e3 == Approx(129.62));
  CHECK(*r.initial_water_content == Approx(0.47));
  CHECK(*r.final_water_content == Approx(0.27));
  CHECK(*r.bulk_density_kg_m3 == Approx(1650));
  CHECK(*r.dry_density_kg_m3 == Approx(1120));
  CHECK(*r.consolidation_pressure_pa / 1e3 == Approx(200));
  CHECK(*r.cell_pressure_pa / 1e3 == Approx(500));
  CHECK(*r.initial_pore_pressure_pa / 1e3 == Approx(301));
  CHECK(*r.pore_pressure_pa / 1e3 == Approx(302));
  CHECK(*r.q_pa / 1e3 == Approx(321));
  CHECK(*r.p_eff_pa() / 1e3 == Approx(305));
  CHECK(*r.s_eff_pa() / 1e3 == Approx(358.5));
  CHECK(*r.t_pa() / 1e3 == Approx(160.5));
  CHECK(*r.axial_strain == Approx(0.113));
  CHECK_FALSE(r.volumetric_strain);
  CHECK_FALSE(r.cohesion_pa);
  CHECK_FALSE(r.friction_angle_rad);
  CHECK(r.failure_mode == "Plastic");
  CHECK(r.remarks == "TREG_COH = NA TREG_PHI = NA");
  REQUIRE(all.warnings.size() == 1);
  CHECK(all.warnings[0].line == 223);
}
