// SPDX-License-Identifier: GPL-3.0-or-later
// Bad records: one clear line each, status 2, database untouched.
#include <catch2/catch.hpp>
#include <regex>

#include "tests/cli/program.hpp"

using namespace triax::cli_tests;

namespace {

const std::string kHeadings =
    "time_s,axial_displacement_mm,axial_force_kN,cell_pressure_kPa,back_pressure_kPa,"
    "pore_pressure_kPa,back_volume_mm3\n";

std::string rows(int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += std::to_string(i) + "," + std::to_string(0.01 * i) + ",0.02,800,500,500,0\n";
  return text;
}

/// Rows after rows(40) whose displacement is larger than the specimen.
std::string impossible_strains(int count) {
  std::string text;
  for (int i = 40; i < 40 + count; ++i) text += std::to_string(i) + ",150,0.02,800,500,500,0\n";
  return text;
}

std::string replaced(const std::string& text, const std::string& what, const std::string& by) {
  return std::regex_replace(text, std::regex(what), by);
}

const std::string kSpecimen = " --set specimen.height_mm=140 --set specimen.diameter_mm=70";

}  // namespace

TEST_CASE("each kind of bad record is one clear line, status 2, and leaves nothing behind") {
  const std::string good = kHeadings + rows(40);
  struct Bad {
    std::string name, text, says;
  };
  const Bad all[] = {
      {"empty", "", "empty"},
      {"header only", kHeadings, "headings without a row of readings; the record is empty"},
      {"semicolons", replaced(good, ",", ";"), "comma"},
      {"bars", replaced(good, ",", "|"), "separated by pipe"},
      {"missing channel", replaced(good, "axial_force_kN", "something_else"), "axial_force_kN"},
      {"two of one name", replaced(good, "back_volume_mm3", "axial_force_kN"), "axial_force_kN"},
      {"text in a number", good + "40,abc,0.02,800,500,500,0\n",
       ":42: column 'axial_displacement_mm'"},
      {"NaN", good + "40,0.4,NaN,800,500,500,0\n", ":42"},
      {"infinite", good + "40,0.4,inf,800,500,500,0\n", ":42"},
      {"strains beyond 1", good + impossible_strains(6), ": axial strain"},
      {"time all equal",
       kHeadings + replaced(rows(1), "0,0.0", "5,0.0") +
           "5,0.1,0.02,800,500,500,0\n"
           "5,0.2,0.02,800,500,500,0\n",
       "time is the same"},
      {"truncated", good + "40,0.4,0.0", "truncated"},
      {"a row too short", good + "40,0.4,0.02\n41,0.4,0.02,800,500,500,0\n", ":42"},
      {"zeros", std::string(100000, '\0'), "NUL"},
  };
  for (const Bad& bad : all) {
    const Workplace here;
    write(here / "bad.csv", bad.text);
    const Outcome outcome = here.triax("replay bad.csv" + kSpecimen);
    INFO(bad.name << ": " << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(outcome.err.rfind("triax: bad.csv", 0) == 0);
    CHECK(outcome.err.find(bad.says) != std::string::npos);
    CHECK_FALSE(here.has("triax.db"));
  }
}

TEST_CASE("a folder, a file that is not there, and 2 GB of zeros are told at once") {
  const Workplace here;
  std::filesystem::create_directory(here / "folder.csv");
  write(here / "zeros.csv", "");
  std::filesystem::resize_file(here / "zeros.csv", 2'000'000'000);  // sparse: takes no room
  for (const char* name : {"folder.csv", "nothing.csv", "zeros.csv"}) {
    const Outcome outcome = here.triax(std::string("replay ") + name);
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK_FALSE(here.has("triax.db"));
  }
}

TEST_CASE("an existing database stays as it is, to the byte") {
  const Workplace here;
  write(here / "good.csv", kHeadings + rows(200));
  REQUIRE(here.triax("replay good.csv" + kSpecimen).status == 0);
  const std::string before = content(here / "triax.db");
  write(here / "bad.csv", kHeadings + rows(200) + "200,abc,0.02,800,500,500,0\n");
  CHECK(here.triax("replay bad.csv" + kSpecimen).status == 2);
  CHECK(content(here / "triax.db") == before);
}

TEST_CASE("a record that turns bad after hundreds of thousands of rows leaves no test behind") {
  const Workplace here;
  write(here / "good.csv", kHeadings + rows(200));
  REQUIRE(here.triax("replay good.csv" + kSpecimen).status == 0);
  std::string late = kHeadings;
  for (int k = 0; k < 300000; ++k) late += std::to_string(k) + ",0.01,0.02,800,500,500,0\n";
  write(here / "late.csv", late + "300000,abc,0.02,800,500,500,0\n");
  CHECK(here.triax("replay late.csv" + kSpecimen).status == 2);
  CHECK(here.triax("query \"SELECT count(*) AS n FROM tests\" --format csv").out == "n\r\n1\r\n");
  CHECK(here.triax("query \"SELECT count(*) AS n FROM scans\" --format csv").out == "n\r\n200\r\n");
}

TEST_CASE("wrong keys and programmes are named") {
  const Workplace here;
  write(here / "good.csv", kHeadings + rows(40));
  const Outcome key = here.triax("replay good.csv --set specimen.hieght_mm=140");
  CHECK(key.status == 2);
  CHECK(key.err.find("specimen.height_mm") != std::string::npos);
  write(here / "p.toml", "[test]\nname = \"x\"\nspeeed = 1\n");
  const Outcome programme = here.triax("simulate p.toml");
  CHECK(programme.status == 2);
  CHECK(programme.err.find("p.toml:") != std::string::npos);
  CHECK_FALSE(here.has("triax.db"));
}

TEST_CASE("of several records a bad one does not sink the others") {
  const Workplace here;
  write(here / "good.csv", kHeadings + rows(40));
  write(here / "bad.csv", "time_s,axial_strain\n0,abc\n");
  write(here / "no_height.csv", kHeadings + rows(40));
  const Outcome head = here.triax("replay good.csv bad.csv" + kSpecimen);
  CHECK(head.status == 2);
  CHECK(head.err.rfind("triax: bad.csv:", 0) == 0);  // told before the first has run
  CHECK(head.err.find("1 of 2 records could not be read") != std::string::npos);
  CHECK(head.out.find("Test 1: good") != std::string::npos);
  CHECK(here.triax("replay good.csv no_height.csv --db other.db").status == 2);
  CHECK_FALSE(here.has("other.db"));
}

TEST_CASE("a record that turns bad on the way costs the finished ones neither place nor report") {
  const Workplace here;
  write(here / "good.csv", kHeadings + rows(40));
  write(here / "late.csv", kHeadings + rows(40) + "40,abc,0.02,800,500,500,0\n");
  const Outcome outcome = here.triax("replay good.csv late.csv good.csv" + kSpecimen);
  CHECK(outcome.status == 2);
  CHECK(outcome.err.rfind("triax: late.csv:42: ", 0) == 0);
  CHECK(outcome.out.find("Test 1: good") != std::string::npos);
  CHECK(here.triax("query \"SELECT test FROM tests\" --format csv").out ==
        "test\r\ngood\r\ngood\r\n");
}

TEST_CASE("a wrong unit shows in the first cell that nothing can have measured") {
  const Workplace here;
  const std::string good = kHeadings + rows(40);
  struct Absurd {
    std::string row, says;
  };
  for (const Absurd& absurd : {Absurd{"40,20000,0.02,800,500,500,0\n", "axial_displacement_mm"},
                               Absurd{"40,0.4,-2e6,800,500,500,0\n", "axial_force_kN"},
                               Absurd{"40,0.4,0.02,8000000,500,500,0\n", "cell_pressure_kPa"}}) {
    write(here / "bad.csv", good + absurd.row);
    const Outcome outcome = here.triax("replay bad.csv" + kSpecimen);
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.rfind("triax: bad.csv:42: column '" + absurd.says + "'", 0) == 0);
    CHECK(outcome.err.find("check the unit") != std::string::npos);
  }
}

TEST_CASE("specimens that cannot be are refused at the key") {
  const Workplace here;
  write(here / "good.csv", kHeadings + rows(40));
  for (const char* set :
       {"specimen.height_mm=1e300", "specimen.diameter_mm=4", "specimen.void_ratio=-1",
        "specimen.void_ratio=21", "specimen.limit_friction_angle_deg=500",
        "specimen.membrane_thickness_mm=11", "specimen.specific_gravity=0.5",
        "specimen.dry_mass_g=1e30", "specimen.height_m=4"}) {
    const Outcome outcome = here.triax(std::string("replay good.csv --set ") + set);
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find(set) != std::string::npos);
    CHECK(outcome.err.find("expected ") != std::string::npos);
  }
}
