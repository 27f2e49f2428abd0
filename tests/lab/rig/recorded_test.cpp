// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/recorded.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "tests/lab/rig/rig_text.hpp"

using namespace triax::lab;
using enum Quantity;
using triax::lab::test::all_readings;

namespace {

std::unique_ptr<RecordedRig> open_text(const std::string& text, const RecordOptions& options = {}) {
  return open_record(open_memory("m.csv", text), options);
}

const std::string kHeadings = "time_s,axial_displacement_mm,axial_force_kN,cell_pressure_kPa\n";

}  // namespace

TEST_CASE("a bare record is one stage of shear with its readings numbered from 0") {
  const auto rig = open_text(kHeadings + "0,0,0.1,800\n0.5,0.1,0.2,800\n1,0.2,0.3,800\n");
  CHECK(rig->header().name == "m");
  CHECK(rig->header().is_raw());
  REQUIRE(rig->header().stages.size() == 1);
  CHECK(rig->header().stages[0].role == StageRole::shear);
  CHECK(rig->header().stages[0].drainage == Drainage::unknown);
  const auto readings = all_readings(*rig);
  REQUIRE(readings.size() == 3);
  CHECK(readings[2].number == 2);
  CHECK(readings[2].time_s == 1);
  CHECK(readings[2].line == 4);
  CHECK(readings[2][axial_force] == 300);
  CHECK(rig->progress() == 1);
  Reading reading;
  CHECK_FALSE(rig->next(reading));
}

TEST_CASE("RecordedRig: without dimensions the stresses of the file are used") {
  const std::string rows =
      "Axial displacement (mm),Axial force (kN),Cell pressure (kPa),Pore pressure (kPa),"
      "Axial strain (mm/mm),Deviator stress "
      "(kPa)\n0,0,300,200,0,0\n0.5,0.1,300,210,0.005,40\n1,0.15,300,220,0.01,60\n";
  const auto reduced = open_text(rows);
  CHECK_FALSE(reduced->header().is_raw());
  CHECK(std::ranges::any_of(reduced->header().warnings, [](const Warning& one) {
    return one.text.find("does not state height and diameter") != std::string::npos;
  }));
  RecordOptions options;
  options.sets = {{"specimen.height_mm", "100"}, {"specimen.diameter_mm", "50"}};
  CHECK(open_text(rows, options)->header().is_raw());
}

TEST_CASE("RecordedRig: without a pore pressure the stresses of the file are used") {
  const std::string rows =
      "Axial displacement (mm),Axial force (kN),Cell pressure (kPa),Axial strain (mm/mm),"
      "Effective axial stress (kPa),Effective radial stress (kPa)\n"
      "0,0,300,0,100,100\n0.5,0.1,300,0.005,130,90\n1,0.15,300,0.01,140,80\n";
  RecordOptions options;
  options.sets = {{"specimen.height_mm", "100"}, {"specimen.diameter_mm", "50"}};
  const auto reduced = open_text(rows, options);
  CHECK_FALSE(reduced->header().is_raw());
  CHECK(std::ranges::any_of(reduced->header().warnings, [](const Warning& one) {
    return one.text.find("has no pore pressure") != std::string::npos;
  }));
}

TEST_CASE("the digest is of all bytes of the record and of nothing else") {
  const auto digest = [](const std::string& text, const RecordOptions& options = {}) {
    return open_text(text, options)->header().digest;
  };
  const std::string record = kHeadings + "0,0,0.1,800\n0.5,0.1,0.2,800\n";
  CHECK(digest(record).size() == 64);
  RecordOptions options;
  options.sets = {{"specimen.height_mm", "150"}};
  CHECK(digest(record, options) == digest(record));
  CHECK(digest(record + "1,0.2,0.3,800\n") != digest(record));
  CHECK(digest("## a remark\n" + record) != digest(record));
}

TEST_CASE("what is set is stronger than what the file says") {
  RecordOptions options;
  options.sets = {
      {"specimen.height_mm", "150"}, {"test.name", "other"}, {"stages.1.drainage", "closed"}};
  const auto rig = open_text(
      "# [test]\n# name = \"file\"\n# [specimen]\n# height_mm = 140\n"
      "# diameter_mm = 70\n" +
          kHeadings + "0,0,0,1\n1,0,0,1\n",
      options);
  CHECK(rig->header().name == "other");
  CHECK(*rig->header().specimen.height_m == Approx(0.15));
  CHECK(*rig->header().specimen.diameter_m == Approx(0.07));
  CHECK(rig->header().stages[0].drainage == Drainage::closed);
  options.sets = {{"specimen.hight_mm", "1"}};
  CHECK_THROWS_WITH(open_text(kHeadings + "0,0,0,1\n", options),
                    Catch::StartsWith("--set specimen.hight_mm=1: unknown key"));
}

TEST_CASE("errors in the preamble have its line") {
  CHECK_THROWS_WITH(open_text("# [specimen]\n# hight_mm = 1\n" + kHeadings + "0,0,0,1\n"),
                    Catch::StartsWith("m.csv:2: unknown key"));
  CHECK_THROWS_WITH(open_text("# a remark\n" + kHeadings + "0,0,0,1\n"),
                    Catch::Contains("with ##"));
  CHECK_NOTHROW(open_text("## a remark\n" + kHeadings + "0,0,0,1\n"));
}

TEST_CASE("a time that stands still and a column without values are refused") {
  const auto drain = [](const std::string& text) {
    const auto rig = open_text(text);
    all_readings(*rig);
  };
  CHECK_THROWS_WITH(drain(kHeadings + "3,0,0,1\n3,0,0,1\n3,0,0,1\n"),
                    Catch::Contains("m.csv:4: the time is the same in all 3 rows"));
  CHECK_THROWS_WITH(drain(kHeadings + "1,0,,1\n2,0,,1\n"),
                    Catch::Contains("a column without any value"));
  CHECK_NOTHROW(drain(kHeadings + "3,0,0,1\n"));
}

TEST_CASE("the example dialect reads the example record") {
  RecordOptions options;
  options.dialect = "samples/dialects/my_lab.toml";
  const auto rig = open_record("samples/dialects/my_lab_record.txt", options);
  CHECK(rig->header().dialect == "my_lab");
  CHECK(*rig->header().specimen.height_m == Approx(0.14));
  const auto readings = all_readings(*rig);
  REQUIRE(readings.size() == 9);
  CHECK(readings[1].time_s == 30);
  CHECK(readings[4][axial_strain] == Approx(0.004));
  CHECK(readings[4][deviator_stress] == Approx(46.5e3));
  CHECK(readings[8][effective_radial_stress] == Approx(11.5e3));
}

TEST_CASE("metadata can stand in a TOML file beside the record") {
  const RecordOptions options;
  const std::string rows = kHeadings + "0,0,0,1\n1,0,0,1\n";
  RecordedRig rig(open_memory("m.csv", rows), options, "m.toml", "[test]\nname = \"beside\"\n");
  CHECK(rig.header().name == "beside");
  CHECK_THROWS_WITH(RecordedRig(open_memory("m.csv", rows), options, "m.toml", "[test]\nnam = 1\n"),
                    Catch::StartsWith("m.toml:2: unknown key 'test.nam'"));
}

TEST_CASE("a simulated record is never changed") {
  const auto rig = open_text(
      "# [test]\n# origin = \"simulated\"\n"
      "stage,time_s,axial_displacement_mm,axial_force_kN,cell_pressure_kPa\n"
      "1,0,5,0,1\n2,1,0,0,1\n");
  CHECK(all_readings(*rig)[1][axial_displacement] == 0);
}

TEST_CASE("--set does not say where a record came from") {
  for (const char* key : {"test.origin", "test.seed"}) {
    RecordOptions options;
    options.sets = {{key, key == std::string("test.seed") ? "1" : "recorded"}};
    const std::string text =
        "# [test]\n# origin = \"simulated\"\naxial_strain,deviator_stress_kPa,"
        "mean_effective_stress_kPa\n0,0,100\n0.1,5,101\n";
    CHECK_THROWS_WITH(open_record(open_memory("s.csv", text), options),
                      Catch::Matchers::Contains(key) && Catch::Matchers::Contains("cannot be set"));
  }
}

TEST_CASE("--set for a stage that the record does not have is refused, with those it has") {
  const std::string headings = "stage,axial_strain,deviator_stress_kPa,mean_effective_stress_kPa\n";
  const std::string rows = "1,0,0,100\n2,0.1,5,101\n2,0.2,6,101\n";
  const auto role_of = [&](const std::string& text, const char* key, int stage) {
    RecordOptions options;
    options.sets = {{key, "shear"}};
    const auto rig = open_record(open_memory("s.csv", text), options);
    return rig->header().stage(stage)->role;
  };
  const std::string described = "# [[stages]]\n# number = 1\n";
  CHECK_THROWS_WITH(role_of(headings + rows, "stages.9.role", 9),
                    Catch::Matchers::Contains("s.csv has no stage 9; it has 1, 2"));
  CHECK_THROWS_WITH(role_of(described + headings + rows, "stages.9.role", 9),
                    Catch::Matchers::Contains("it has 1, 2"));
  // Not described, but there.
  CHECK(role_of(described + headings + rows, "stages.2.role", 2) == StageRole::shear);
  const std::string single =
      "axial_strain,deviator_stress_kPa,mean_effective_stress_kPa\n0,0,100\n0.1,5,101\n";
  CHECK(role_of(single, "stages.1.role", 1) == StageRole::shear);
  CHECK_THROWS_WITH(role_of(single, "stages.2.role", 2), Catch::Matchers::Contains("it has 1"));
}

TEST_CASE("stage 4.1 beside stage 41 is refused where the second of them begins") {
  const std::string text =
      "# [[stages]]\n# number = 41\nstage,axial_strain,deviator_stress_kPa,"
      "mean_effective_stress_kPa\n4.1,0,0,100\n41,0.1,5,101\n";
  const auto rig = open_record(open_memory("s.csv", text), {});
  Reading reading;
  REQUIRE(rig->next(reading));
  CHECK(reading.stage == 41);
  CHECK_THROWS_WITH(rig->next(reading), Catch::Matchers::Contains("s.csv:5: "));
}

TEST_CASE("a dimension that is said and contradicts the file's own is told") {
  const std::string record =
      "# [specimen]\n# height_mm = 140\n# diameter_mm = 70\n" + kHeadings + "0,0,0.1,800\n";
  const auto warnings = [&](const char* key, const char* value) {
    return open_text(record, {.sets = {{key, value}}})->header().warnings;
  };
  REQUIRE(warnings("specimen.height_mm", "14").size() == 1);
  CHECK(warnings("specimen.height_mm", "14")[0].text ==
        "--set specimen.height_mm=14 replaces 140 mm of the record");
  CHECK(warnings("specimen.height_cm", "14").empty());
  CHECK(warnings("specimen.void_ratio", "0.9").empty());
}

TEST_CASE("what is said of a stage is asked no more, and what was not said still is") {
  // Numbered stages: consolidation, then a deviator load on a cap that hardly moves.
  std::string record =
      "\"Initial Height (mm)\",\"100\"\r\n\"Initial Diameter (mm)\",\"50\"\r\n"
      "\"Stage Number\",\"Time since start of test (s)\",\"Time since start of stage (s)\","
      "\"Radial Pressure (kPa)\",\"Back Volume (mm³)\",\"Load Cell (kN)\","
      "\"Pore Pressure (kPa)\",\"Axial Displacement (mm)\"\r\n";
  for (int i = 0; i < 80; ++i) {
    const bool loads = i >= 40;
    const double x = loads ? (i - 40) / 39.0 : i / 39.0;
    record += fmt::format("\"{}\",\"{}\",\"{}\",\"{}\",\"{}\",\"{}\",\"{}\",\"{}\"\r\n",
                          loads ? 2 : 1, i, loads ? i - 40 : i, loads ? 400.0 : 350 + 50 * x,
                          loads ? -8000 - 120 * x : -8000 * x, loads ? 0.06 * x : 0, 300,
                          loads ? 0.5 + 0.1 * x : 0.5 * x);
  }
  const auto asked = [&](const RecordOptions& options) {
    const auto rig = open_record(open_memory("m.gds", record), options);
    std::vector<std::string> keys;
    for (const Guess& guess : rig->header().guesses)
      for (const Guess::Said& said : guess.otherwise) keys.push_back(said.key + "=" + said.value);
    return keys;
  };
  using Keys = std::vector<std::string>;
  CHECK(asked({}) == Keys{"stages.2.drainage=closed", "stages.2.role=consolidation"});
  CHECK(asked({.sets = {{"stages.2.role", "shear"}}}) == Keys{"stages.2.drainage=closed"});
  CHECK(asked({.sets = {{"stages.2.drainage", "open"}}}) == Keys{"stages.2.role=consolidation"});
  CHECK(asked({.sets = {{"stages.2.drainage", "open"}, {"stages.2.role", "shear"}}}).empty());
}

namespace {

/// Undrained shear as a table of reduced columns without time, in `count` rows.
std::vector<std::string> table_rows(int count) {
  std::vector<std::string> rows;
  for (int i = 0; i < count; ++i)
    rows.push_back(fmt::format("{:.3f}\t{:.3f}\t{:.3f}\n", 0.1 * i, 2.5 * i, 100.0 - i));
  return rows;
}

std::unique_ptr<RecordedRig> open_table(const std::vector<std::string>& rows) {
  std::string text = "eps1\tq\tp\n[%]\t[kPa]\t[kPa]\n";
  for (const std::string& row : rows) text += row;
  return open_record(open_memory("m.dat", text), {});
}

}  // namespace

TEST_CASE("RecordedRig: a second test in the file is an error with its reading") {
  auto rows = table_rows(30);
  const auto again = rows;
  for (int i = 0; i < 2; ++i) rows.insert(rows.end(), again.begin(), again.end());
  const auto rig = open_table(rows);
  CHECK_THROWS_WITH(all_readings(*rig),
                    Catch::StartsWith("m.dat:33: a second test begins with reading 30: "));
}

TEST_CASE("RecordedRig: rows in reverse order are read from the last one") {
  auto rows = table_rows(30);
  const auto straight = all_readings(*open_table(rows));
  std::ranges::reverse(rows);
  const auto rig = open_table(rows);
  const auto readings = all_readings(*rig);
  REQUIRE(readings.size() == straight.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    CHECK(readings[i].si[index(Quantity::axial_strain)] ==
          straight[i].si[index(Quantity::axial_strain)]);
    CHECK(readings[i].line == straight[readings.size() - 1 - i].line);
  }
  CHECK(std::ranges::any_of(rig->header().warnings, [](const Warning& warning) {
    return warning.text.starts_with("the rows are in reverse order");
  }));
}

TEST_CASE("RecordedRig: rows that are missing are a warning with the line") {
  auto rows = table_rows(40);
  rows.erase(rows.begin() + 20, rows.begin() + 23);
  const auto rig = open_table(rows);
  CHECK(all_readings(*rig).size() == 37);
  CHECK(std::ranges::any_of(rig->header().warnings, [](const Warning& warning) {
    return warning.line == 23 && warning.text.starts_with("3 rows are missing before this line");
  }));
}

TEST_CASE("RecordedRig: a back pressure in another unit is a warning") {
  const auto rig = open_text(
      "time_s,axial_displacement_mm,axial_force_kN,cell_pressure_kPa,back_pressure_MPa\n"
      "0,0,0.1,400,300\n0.5,0.1,0.2,400,300\n");
  all_readings(*rig);
  CHECK(std::ranges::any_of(rig->header().warnings, [](const Warning& warning) {
    return warning.line == 2 && warning.text.starts_with("the back pressure, 300000 kPa");
  }));
}

TEST_CASE("RecordedRig: a record without a stage column says what was taken as shear") {
  const std::string rows = "0,0,0.1,800\n1,0.1,0.2,800\n2,0.2,0.3,800\n";
  const auto role_of = [](const RecordedRig& rig) {
    const auto& guesses = rig.header().guesses;
    const auto found = std::ranges::find(guesses, "role", &Guess::what);
    return found == guesses.end() ? std::string() : found->taken;
  };
  CHECK(role_of(*open_text(kHeadings + rows)) == "shear in all readings");
  CHECK(role_of(*open_text(kHeadings + rows, {.sets = {{"stages.1.role", "shear"}}})).empty());
  CHECK(role_of(*open_text("stage," + kHeadings + "1,0,0,0.1,800\n1,1,0.1,0.2,800\n")).empty());
}

TEST_CASE("RecordedRig: a raw record without a stage column has the stages of its readings") {
  std::string rows =
      "Height (mm),100\nDiameter (mm),50\n\nTime (s),Axial displacement (mm),Axial force (kN),"
      "Cell pressure (kPa),Back pressure (kPa),Pore pressure (kPa),Back volume (mm3)\n";
  for (int i = 0; i < 50; ++i)
    rows += fmt::format("{},0,{},{},300,300.0,{}\n", i, 0.0001 * (i % 2), 320 + 4 * i, -100 * i);
  for (int i = 50; i < 150; ++i)
    rows += fmt::format("{},{},{},516,300,{},-4900\n", i, 0.1 * (i - 49), 0.005 * (i - 49),
                        300 + 1.2 * (i - 49));
  const auto rig = open_text(rows);
  const auto& header = rig->header();
  REQUIRE(header.stages.size() == 2);
  CHECK(header.stages[0].role == StageRole::consolidation);
  CHECK(header.stages[0].drainage == Drainage::open);
  CHECK(header.stages[1].role == StageRole::shear);
  CHECK(header.stages[1].drainage == Drainage::closed);
  REQUIRE(header.guesses.size() == 2);
  CHECK(header.guesses[0].what == "stages");
  CHECK(header.guesses[0].taken.find("; 2 (shear, drainage closed) from line 5") !=
        std::string::npos);
  const auto readings = all_readings(*rig);
  REQUIRE(readings.size() == 150);
  CHECK(readings[40].stage == 1);
  CHECK(readings[60].stage == 2);
}

TEST_CASE("RecordedRig: a drainage that the readings do not show is assessed both ways") {
  const auto others_of = [](double pore_rise, double outflow) {
    std::string rows =
        "Height (mm),100\nDiameter (mm),50\n\nTime (s),Axial displacement (mm),Axial force (kN),"
        "Cell pressure (kPa),Back pressure (kPa),Pore pressure (kPa),Back volume (mm3)\n";
    for (int i = 0; i < 100; ++i)
      rows += fmt::format("{},{},{},500,300,{},{}\n", i, 0.1 * i, 0.002 * i,
                          300 + pore_rise * i / 99, -outflow * i / 99);
    const auto rig = open_text(rows);
    std::vector<std::string> drainages;
    for (const Guess& guess : rig->header().guesses)
      for (const Guess::Said& said : guess.otherwise)
        if (said.key == "stages.1.drainage") drainages.push_back(said.value);
    return drainages;
  };
  CHECK(others_of(100, 0).empty());
  CHECK(others_of(0, 2000).empty());
  CHECK(others_of(100, 1000) == std::vector<std::string>{"closed"});
  CHECK(others_of(0, 0) == std::vector<std::string>{"open"});
}

TEST_CASE("RecordedRig: readings of a rounded clock are evenly spread") {
  const auto rig =
      open_text(kHeadings + "0,0,0.1,800\n0,0.1,0.2,800\n1,0.2,0.3,800\n1,0.3,0.4,800\n");
  const auto readings = all_readings(*rig);
  REQUIRE(readings.size() == 4);
  CHECK(readings[1].time_s == 0.5);
  CHECK(readings[2].time_s == 1);
  CHECK(readings[3].time_s > 1);
}
