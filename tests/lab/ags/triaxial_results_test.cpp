// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/triaxial_results.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;

namespace {

AgsResults read_text(const std::string& text) {
  return read_triaxial_results(*open_memory("x.ags", text));
}

std::string group(const std::string& name, const std::string& headings, const std::string& units,
                  const std::string& rows) {
  return "GROUP," + name + "\nHEADING," + headings + "\nUNIT," + units + "\n" + rows + "\n";
}

bool told(const AgsResults& all, const std::string& text) {
  return std::ranges::any_of(all.warnings, [&](const Warning& warning) {
    return warning.text.find(text) != std::string::npos;
  });
}

}  // namespace

TEST_CASE("the sample delivery: three stages of one test, a drained and a quick one") {
  const AgsResults all = read_triaxial_results(*open_file("samples/records/results.ags"));
  CHECK(all.edition == "4.1");
  CHECK(all.project == "A made-up slope");
  CHECK(all.warnings.empty());
  REQUIRE(all.results.size() == 5);
  const ReferenceResult& quick = all.results[0];
  CHECK(quick.group == "TRIT");
  CHECK(quick.test_type == "UU");
  CHECK(*quick.height_m == Approx(0.204));
  CHECK(*quick.undrained_strength_pa == 43e3);
  CHECK(*quick.t_pa() == 43e3);
  CHECK_FALSE(quick.p_eff_pa());  // no pore pressure was measured
  const ReferenceResult& third = all.results[3];
  CHECK(third.specimen.location == "BH7");
  CHECK(third.specimen.sample_id == "BH7-12");
  CHECK(third.specimen.specimen_depth_m == 6.55);
  CHECK(third.stage == "3");
  CHECK(third.test_type == "CIUCM");
  CHECK(*third.cell_pressure_pa == 700e3);
  CHECK(*third.p_eff_pa() == Approx(333e3));
  CHECK(*third.s_eff_pa() == Approx(395e3));
  CHECK(*third.axial_strain == Approx(0.087));
  CHECK(*third.cohesion_pa == 4e3);
  CHECK(*third.friction_angle_rad == Approx(0.479966));
  CHECK(third.failure_criterion == "Maximum stress ratio");
  CHECK_FALSE(third.diameter_m);  // told with the first stage only, and not assumed for others
  const ReferenceResult& drained = all.results[4];
  CHECK(*drained.volumetric_strain == Approx(-0.0121));
  CHECK(*drained.bulk_density_kg_m3 == Approx(1930));
  CHECK(*drained.b_value == 0.96);
  CHECK_FALSE(drained.cohesion_pa);
}

TEST_CASE("headings in any order, other units, a general row below its results") {
  const AgsResults all =
      read_text(group("TRET", "TRET_DEVF,TRET_TESN,LOCA_ID,TRET_CELL,TRET_PWPF,TRET_BDEN",
                      "MPa,,,bar,kPa,kg/m3", "DATA,0.12,2,BH1,4,250,1980\n") +
                group("TREG", "TREG_PHI,TREG_TYPE,LOCA_ID", "rad,,", "DATA,0.5,CD,BH1\n"));
  REQUIRE(all.results.size() == 1);
  const ReferenceResult& r = all.results[0];
  CHECK(*r.q_pa == Approx(120e3));
  CHECK(*r.cell_pressure_pa == Approx(400e3));
  CHECK(*r.s_eff_pa() == Approx(210e3));
  CHECK(*r.bulk_density_kg_m3 == Approx(1980));
  CHECK(r.test_type == "CD");
  CHECK(*r.friction_angle_rad == 0.5);
  CHECK(all.warnings.empty());
}

TEST_CASE("general rows without results count; results without a general row say so") {
  const AgsResults lone =
      read_text(group("TREG", "LOCA_ID,TREG_COH,TREG_CU", ",kPa,kPa", "DATA,BH1,5,40\n"));
  REQUIRE(lone.results.size() == 1);
  CHECK(lone.results[0].group == "TREG");
  CHECK(*lone.results[0].cohesion_pa == 5e3);
  CHECK(*lone.results[0].undrained_strength_pa == 40e3);
  const AgsResults bare = read_text(group("TRIT", "LOCA_ID,TRIT_CELL", ",kPa", "DATA,B\xFC,5\n"));
  CHECK(bare.results[0].specimen.location == "Bü");
  CHECK(bare.results[0].test_type.empty());
  CHECK(told(bare, "has no row in TRIG"));
  CHECK(told(bare, "Windows-1252"));
}

TEST_CASE("an extension test whose q has no sign has no stresses at failure") {
  const auto q_of = [](const std::string& q) {
    return read_text(group("TREG", "LOCA_ID,TREG_TYPE", ",", "DATA,B,CAUE\n") +
                     group("TRET", "LOCA_ID,TRET_CELL,TRET_PWPF,TRET_DEVF", ",kPa,kPa,kPa",
                           "DATA,B,400,300," + q + "\n"))
        .results.at(0);
  };
  CHECK(*q_of("60").q_pa == 60e3);
  CHECK_FALSE(q_of("60").p_eff_pa());
  CHECK(*q_of("-60").p_eff_pa() == Approx(80e3));
}

TEST_CASE("AGS4 without triaxial results is refused, with the groups that it has") {
  CHECK_THROWS_WITH(read_text(group("PROJ", "PROJ_ID", "", "DATA,1\n") +
                              group("LOCA", "LOCA_ID", "", "DATA,1\n")),
                    "x.ags: AGS4 without a triaxial result: it has the groups PROJ, LOCA, and none "
                    "of them is a triaxial one (TREG, TRET, TRIG, TRIT)");
  CHECK_THROWS_WITH(read_text(group("TRIG", "LOCA_ID", "", "")),
                    Catch::Contains("no row of data in TRIG"));
  CHECK_THROWS_WITH(read_text(group("CTRD", "LOCA_ID", "", "DATA,1\n")),
                    Catch::Contains("CTRD") && Catch::Contains("cyclic"));
  CHECK_THROWS_WITH(read_text(""), Catch::Contains("no group"));
  CHECK_THROWS_WITH(
      read_text(group("TRIT", "LOCA_ID,TRIT_CELL", ",m", "DATA,1,5\n")),
      Catch::Contains("x.ags:3: TRIT_CELL is in 'm', which does not fit this quantity"));
}
