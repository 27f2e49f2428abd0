// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/programme_reader.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "lab/base/bad_input.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax::lab;
using Catch::Contains;
using test::programme_text;
using test::replaced;

namespace {
/// What the reader says of the small programme with `from` replaced by `to`.
std::string complaint_of_change(const std::string& from, const std::string& to) {
  try {
    read_programme(replaced(programme_text(), from, to), "p.toml");
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}
}  // namespace

TEST_CASE("a programme is read in SI") {
  const Programme p = read_programme(programme_text({}, R"(back_pressure_kPa = 300.0
water_bulk_modulus_GPa = 2.0
system_compliance_mm3_per_kPa = 0.5
drainage_resistance_kPa_s_per_mm3 = 2.0
[rig.frame]
travel_mm = 30.0
[rig.transducers.axial_force]
range_N = 2000.0
bits = 16
noise_N = 0.3
)") + "[[stages]]\nname = \"s\"\nrole = \"shear\"\ndrainage = \"open\"\naxial = \"load\"\n"
      "load_rate_N_per_min = 60\nend = [{quantity = \"q_kPa\", above = 30}]\n",
                                     "p.toml");
  CHECK(p.specimen.height_m == Approx(0.14));
  CHECK(p.initial_back_pressure_pa == 300e3);
  CHECK(p.specimen.water_compressibility == Approx(5e-10));
  CHECK(p.specimen.system_compliance == Approx(0.5e-9 / 1e3));
  CHECK(p.specimen.drainage_resistance == Approx(2e3 / 1e-9));
  CHECK(p.frame.travel_m == Approx(0.03));
  const Transducer& cell = p.transducers[index(Quantity::axial_force)];
  CHECK(cell.step == Approx(4.0 / 65536));
  CHECK(cell.noise_rms == Approx(0.3e-3));
  REQUIRE(p.stages.size() == 1);
  CHECK(p.stages[0].load_rate_n_per_s == 1);
  CHECK(p.stages[0].end[0].above == 30e3);
  CHECK(p.seed == 3);
}

TEST_CASE("absurd values are refused with file and line") {
  CHECK_THAT(
      complaint_of_change("height_mm = 140.0", "height_mm = -140.0"),
      Contains("p.toml:8: [specimen] height_mm: is -140, must be at least 5 and at most 3000"));
  CHECK_THAT(complaint_of_change("void_ratio = 1.086", "void_ratio = 0"), Contains("p.toml:10"));
  CHECK_THAT(complaint_of_change("void_ratio = 1.086", "void_ratio = 2.98"), Contains("2.97"));
  CHECK_THAT(complaint_of_change("S28-general", "S28-genral"),
             Contains("p.toml:7") && Contains("did you mean 'sanisand/S28-general'?"));
  CHECK_THAT(complaint_of_change("scan_interval_s = 1.0", "scan_interval_s = 0"),
             Contains("p.toml:5"));
  CHECK_THAT(complaint_of_change("height_mm = 140.0", "hieght_mm = 140.0"),
             Contains("height_mm") && Contains("hieght_mm"));
  CHECK_THAT(complaint_of_change("seed = 3", "seed = 3\nsede = 4"),
             Contains("p.toml:5") && Contains("did you mean 'seed'?"));
  CHECK_THAT(complaint_of_change("name = \"small\"", "name = small"), Contains("p.toml:2"));
  CHECK_THAT(complaint_of_change("[rig]", "[rigg]"), Contains("[rig] is missing"));
  CHECK_THAT(complaint_of_change("back_pressure_kPa = 300.0", "back_pressure_kPa = 9e9"),
             Contains("p.toml:13"));
}

TEST_CASE("specimens and pressures that cannot be are refused at the key") {
  for (const char* height : {"1e300", "4.9", "3001", "-140"})
    CHECK_THAT(complaint_of_change("height_mm = 140.0", std::string("height_mm = ") + height),
               Contains("p.toml:8") && Contains("height_mm"));
  CHECK_THAT(complaint_of_change("diameter_mm = 70.0", "diameter_mm = 1e9"), Contains("p.toml:9"));
  CHECK_THAT(complaint_of_change("void_ratio = 1.086", "void_ratio = 21"),
             Contains("p.toml:10") && Contains("at most 20"));
  for (const char* table : {"cell_controller", "back_controller", "transducers.cell_pressure"})
    CHECK_THAT(complaint_of_change("back_pressure_kPa = 300.0",
                                   std::string("back_pressure_kPa = 300.0\n[rig.") + table +
                                       "]\nrange_kPa = 100001"),
               Contains("p.toml:15") && Contains("at most 100000"));
}

TEST_CASE("a transducer's noise is not negative and its converter has a range") {
  const auto with = [](const std::string& lines) {
    return programme_text("",
                          "back_pressure_kPa = 300.0\n[rig.transducers.cell_pressure]\n" + lines);
  };
  CHECK_THROWS_WITH(read_programme(with("noise_kPa = -1\n"), "p.toml"), Contains("p.toml:15"));
  CHECK_THROWS_WITH(read_programme(with("bits = 16\n"), "p.toml"), Contains("needs range_kPa"));
  CHECK_THROWS_WITH(read_programme(with("noise_mm = 1\n"), "p.toml"),
                    Contains("did you mean 'noise_kPa'?"));
}

TEST_CASE("a programme without stages, an empty file, a folder and no file are refused") {
  CHECK_THROWS_WITH(read_programme(programme_text(""), "p.toml"), Contains("[[stages]]"));
  CHECK_THROWS_AS(read_programme("", "p.toml"), BadInput);
  CHECK_THROWS_WITH(load_programme("tests"), Contains("folder"));
  CHECK_THROWS_WITH(load_programme("no_such.toml"), Contains("no_such.toml"));
  CHECK_THROWS_WITH(load_programme("/dev/zero"), Contains("not a regular file"));
}

TEST_CASE("a user's own material stands beside the programme") {
  CHECK_THAT(complaint_of_change("material = ", "material_file = \"no_such.toml\"\nmaterial = "),
             Contains("no_such.toml"));
  const Programme p = read_programme(
      replaced(programme_text(),
               "material = ", "material_file = \"../../lab/materials/sanisand.toml\"\nmaterial = "),
      "samples/programmes/p.toml");
  CHECK(p.material.parameters.numbers.at("hardening_factor") == 1.224);
  REQUIRE(p.files.size() == 2);
  CHECK(p.files[0] == "samples/programmes/p.toml");
  CHECK(p.files[1] == "samples/programmes/../../lab/materials/sanisand.toml");
}

TEST_CASE("membrane and saturation of the specimen are read in SI, perfect by default") {
  const Programme bare = read_programme(programme_text(), "p.toml");
  CHECK(bare.specimen.membrane_thickness_m == 0);
  CHECK(bare.specimen.membrane_young_modulus_pa == 0);
  CHECK(bare.specimen.membrane_penetration_m == 0);
  CHECK(bare.specimen.saturation == 1);
  const Programme p =
      read_programme(replaced(programme_text(), "void_ratio", R"(membrane_thickness_mm = 0.3
membrane_modulus_kPa = 1400
membrane_penetration_mm3_per_mm2 = 0.02
saturation = 0.98
void_ratio)"),
                     "p.toml");
  CHECK(p.specimen.membrane_thickness_m == Approx(0.3e-3));
  CHECK(p.specimen.membrane_young_modulus_pa == Approx(1.4e6));
  CHECK(p.specimen.membrane_penetration_m == Approx(0.02e-3));
  CHECK(p.specimen.saturation == 0.98);
  CHECK_THAT(complaint_of_change("void_ratio", "saturation = 98\nvoid_ratio"),
             Contains("p.toml:10") && Contains("at most 1"));
  CHECK_THAT(complaint_of_change("void_ratio", "membrane_thickness_mm = 0.3\nvoid_ratio"),
             Contains("p.toml:10") && Contains("needs membrane_modulus_kPa"));
  CHECK_THAT(complaint_of_change("void_ratio", "membrane_modulus_kPa = 1400\nvoid_ratio"),
             Contains("needs membrane_thickness_mm"));
}
