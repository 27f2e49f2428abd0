// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/metadata.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/records/truth_toml.hpp"

using namespace triax::lab;

TEST_CASE("a dimension can be set in any unit of its kind") {
  RecordHeader header;
  set_metadata(header, "--set", "specimen.height_mm", "140");
  CHECK(*header.specimen.height_m == Approx(0.14));
  set_metadata(header, "--set", "specimen.height_cm", "15");
  CHECK(*header.specimen.height_m == Approx(0.15));
  set_metadata(header, "--set", "specimen.void_ratio", "0.87");
  CHECK(*header.specimen.void_ratio == 0.87);
  CHECK_THROWS_AS(set_metadata(header, "--set", "specimen.height_kPa", "1"), BadInput);
}

TEST_CASE("stages are set by their number and made where they do not exist") {
  RecordHeader header;
  set_metadata(header, "--set", "stages.5.role", "shear");
  set_metadata(header, "--set", "stages.5.drainage", "closed");
  REQUIRE(header.stages.size() == 1);
  CHECK(header.stage(5)->role == StageRole::shear);
  CHECK(header.stage(5)->drainage == Drainage::closed);
  CHECK_THROWS_AS(set_metadata(header, "--set", "stages.6.role", "sheer"), BadInput);
  CHECK(header.stages.size() == 1);
}

TEST_CASE("a channel can be said to be sound, and nothing else of it") {
  RecordHeader header;
  set_metadata(header, "--set", "sensors.cell_pressure", "sound");
  set_metadata(header, "--set", "sensors.cell_pressure", "sound");
  CHECK(header.vouched == std::vector{Quantity::cell_pressure});
  CHECK_THROWS_WITH(set_metadata(header, "--set", "sensors.cell_pressure", "dead"),
                    Catch::Contains("expected sound"));
  CHECK_THROWS_WITH(set_metadata(header, "--set", "sensors.cel_pressure", "sound"),
                    Catch::Contains("did you mean 'cell_pressure'"));
  RecordHeader again;
  std::optional<Truth> truth;
  read_metadata(again, truth, TomlTable::parse(metadata_toml(header), "a"));
  CHECK(again.vouched == header.vouched);
}

TEST_CASE("wrong keys and values are refused with what would be right") {
  RecordHeader header;
  CHECK_THROWS_WITH(
      set_metadata(header, "--set", "specimen.hight_mm", "1"),
      Catch::Contains("did you mean 'specimen.height_mm'") && Catch::Contains("stages.N.control"));
  for (const char* value : {"abc", "", "-3", "0", "nan", "inf", "1e999", "14,0"})
    CHECK_THROWS_AS(set_metadata(header, "--set", "specimen.height_mm", value), BadInput);
  CHECK_FALSE(header.specimen.height_m);
  CHECK_THROWS_WITH(
      set_metadata(header, "a:3", "test.origin", "guessed"),
      Catch::Contains(
          "a:3: test.origin = 'guessed' is not valid; must be one of: recorded, simulated"));
  for (const char* key : {"", "test", "stages.x.role", "stages.1", "stages.-1.role", "truth.q_kPa"})
    CHECK_THROWS_AS(set_metadata(header, "--set", key, "1"), BadInput);
}

TEST_CASE("a truth that is finite in no unit is refused") {
  RecordHeader header;
  std::optional<Truth> truth;
  for (const std::string value : {"1e308", "inf", "nan"})
    CHECK_THROWS_WITH(
        read_metadata(header, truth, TomlTable::parse("[truth]\nq_kPa = " + value, "a")),
        Catch::StartsWith("a:2: [truth] q_kPa"));
  CHECK_FALSE(truth);
}

TEST_CASE("metadata written as TOML read back as the same values") {
  RecordHeader header;
  header.name = "a \"quoted\" name, mm³";
  header.origin = Origin::simulated;
  header.programme = "CSU";
  header.seed = kMaxSeed;
  header.cell_pressure_pa = triax::sim::to_si(212.5, *triax::sim::find_unit("kPa"));
  header.specimen.material = "Hostun S28";
  double factor = 1.1234567;
  for (const SpecimenKey& row : specimen_keys())
    header.specimen.*row.member =
        triax::sim::to_si(row.lowest * (factor += 0.137), *triax::sim::find_unit(row.unit));
  header.stages = {
      {1, "isotropic", StageRole::consolidation, Drainage::open, AxialControl::load, {}},
      {2, "", StageRole::shear, Drainage::closed, AxialControl::constant_q, {}},
      {3, "path", StageRole::shear, Drainage::open, AxialControl::displacement, 0.4},
      {4, "", StageRole::hold, Drainage::open, AxialControl::load, {}}};
  RecordHeader found;
  std::optional<Truth> truth;
  read_metadata(found, truth, TomlTable::parse(metadata_toml(header), "m"));
  CHECK(found.name == header.name);
  CHECK(found.origin == Origin::simulated);
  CHECK(found.programme == "CSU");
  CHECK(found.seed == header.seed);
  CHECK(found.cell_pressure_pa == header.cell_pressure_pa);
  for (const SpecimenKey& row : specimen_keys())
    CHECK(found.specimen.*row.member == header.specimen.*row.member);
  REQUIRE(found.stages.size() == 4);
  CHECK(found.stages[2].strain_path_R == 0.4);
  CHECK_FALSE(found.stages[1].strain_path_R);
  CHECK(found.stages[3].role == StageRole::hold);
  CHECK(found.stages[0].name == "isotropic");
  CHECK(found.stages[1].control == AxialControl::constant_q);
  CHECK_FALSE(truth);
}

TEST_CASE("the truth reads back, what is unknown stays empty") {
  Truth truth;
  truth.lost_sustainability = true;
  truth.time_s = 12.25;
  truth.q_pa = triax::sim::to_si(56.49, *triax::sim::find_unit("kPa"));
  RecordHeader header;
  std::optional<Truth> found;
  read_metadata(header, found, TomlTable::parse(truth_toml(truth), "m"));
  REQUIRE(found);
  CHECK(found->lost_sustainability);
  CHECK(found->time_s == truth.time_s);
  CHECK(found->q_pa == truth.q_pa);
  CHECK_FALSE(found->axial_strain);
  CHECK_THROWS_AS(read_metadata(header, found, TomlTable::parse("[truth]\nq_kpa = 1\n", "m")),
                  BadInput);
}

TEST_CASE("names with units come apart") {
  CHECK(split_unit("cell_pressure_kPa")->name == "cell_pressure");
  CHECK(split_unit("cell_pressure_kPa")->unit.scale == 1e3);
  CHECK_FALSE(split_unit("void_ratio"));
  CHECK_FALSE(split_unit("_kPa"));
  CHECK_FALSE(split_unit("x_"));
}

TEST_CASE("a stage that is described twice is refused at the second description") {
  RecordHeader header;
  std::optional<Truth> truth;
  const auto text =
      "[[stages]]\nnumber = 2\n[[stages]]\nnumber = 1\n[[stages]]\nname = \"b\"\nnumber = 2\n";
  CHECK_THROWS_WITH(read_metadata(header, truth, TomlTable::parse(text, "m")),
                    Catch::Matchers::Contains("m:7: ") && Catch::Matchers::Contains("twice"));
}

TEST_CASE("a specimen's bounds themselves are inside, in every unit; a large seed is refused") {
  RecordHeader header;
  for (const char* key : {"specimen.height_mm", "specimen.diameter_mm"})
    for (const char* value : {"5", "3000"}) CHECK_NOTHROW(set_metadata(header, "m", key, value));
  CHECK_NOTHROW(set_metadata(header, "m", "specimen.height_cm", "300"));
  CHECK_THROWS_WITH(set_metadata(header, "m", "specimen.height_cm", "301"),
                    Catch::Matchers::Contains("0.5 to 300 cm"));
  CHECK_NOTHROW(set_metadata(header, "m", "specimen.limit_friction_angle_deg", "89"));
  CHECK_NOTHROW(set_metadata(header, "m", "specimen.void_ratio", "0.05"));
  CHECK_NOTHROW(set_metadata(header, "m", "test.seed", "9223372036854775807"));
  CHECK_THROWS_WITH(set_metadata(header, "m", "test.seed", "9223372036854775808"),
                    Catch::Matchers::Contains("9223372036854775807"));
}
