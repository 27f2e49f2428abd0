// SPDX-License-Identifier: GPL-3.0-or-later
// DIGGS 2.6 from outside: what export writes, replay reads back.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace triax::cli_tests;

namespace {

/// The report of a test without what depends on file and day.
nlohmann::json result_of(const Workplace& here, const std::string& arguments) {
  auto report = nlohmann::json::parse(here.triax("report " + arguments + " --format json").out);
  for (const char* const key : {"id", "source", "dialect", "digest", "stored_at"})
    report["test"].erase(key);
  report.erase("notes");
  return report;
}

bool has_xmllint() { return std::system("xmllint --version >/dev/null 2>&1") == 0; }

bool is_valid(const std::string& options, const std::filesystem::path& file) {
  const std::string command = "xmllint --noout " + options + " '" + file.string() + "'";
  return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

/// A failed check would print the files.
bool is_same(const std::filesystem::path& one, const std::filesystem::path& two) {
  return content(one) == content(two);
}

void check_round_trip(const std::string& record, const std::string& sets = "") {
  INFO(record);
  const Workplace here;
  REQUIRE(here.triax("replay '" + record + "' " + sets).status == 0);
  REQUIRE(here.triax("export 1 --output one.diggs").status == 0);
  const auto out = here.triax("replay one.diggs --db back.db");
  INFO(out.err);
  REQUIRE(out.status == 0);
  REQUIRE(here.triax("export 1 --format csv --output one.csv").status == 0);
  REQUIRE(here.triax("export 1 --format csv --output back.csv --db back.db").status == 0);
  CHECK(is_same(here / "one.csv", here / "back.csv"));
  REQUIRE(here.triax("export 1 --format csv --states --output states.csv").status == 0);
  REQUIRE(
      here.triax("export 1 --format csv --states --output back_states.csv --db back.db").status ==
      0);
  CHECK(is_same(here / "states.csv", here / "back_states.csv"));
  CHECK(result_of(here, "1")["collapse"] == result_of(here, "1 --db back.db")["collapse"]);
  if (has_xmllint()) CHECK(is_valid("--relaxng tests/cli/diggs_export.rng", here / "one.diggs"));
}

}  // namespace

TEST_CASE("DIGGS: exported tests come back with the same bits and results") {
  const Workplace here;
  for (const char* const record : {"icu_6", "csd_58"})
    REQUIRE(
        here.triax("replay " + source("samples/records/" + std::string(record) + ".csv")).status ==
        0);
  const auto out = here.triax("export --output all.xml --set LOCA_ID=BH1 --set 1/SAMP_REF=22");
  CHECK(out.status == 0);
  CHECK(out.err == "triax: wrote all.xml\n");
  REQUIRE(here.triax("replay all.xml --db back.db").status == 0);
  for (const std::string test : {"1", "2"}) {
    CHECK(result_of(here, test) == result_of(here, test + " --db back.db"));
    REQUIRE(here.triax("export " + test + " --format csv --output one.csv").status == 0);
    REQUIRE(here.triax("export " + test + " --format csv --output two.csv --db back.db").status ==
            0);
    CHECK(is_same(here / "one.csv", here / "two.csv"));
  }
  const auto report = nlohmann::json::parse(here.triax("report 1 --format json --db back.db").out);
  CHECK(report["notes"][0]["label"] == "Borehole");
  CHECK(report["notes"][0]["text"] == "BH1");
  CHECK(content(here / "all.xml").find("SIMULATED, not measured") != std::string::npos);
}

TEST_CASE("DIGGS: tests of one file are counted separately") {
  const Workplace here;
  for (const char* const record : {"icu_6", "csd_58"})
    REQUIRE(
        here.triax("replay " + source("samples/records/" + std::string(record) + ".csv")).status ==
        0);
  REQUIRE(here.triax("export --output all.xml").status == 0);
  REQUIRE(here.triax("replay all.xml --db back.db").status == 0);
  const auto out = here.triax("query 'SELECT count(*) AS n FROM counted_tests' --db back.db");
  CHECK(out.out.find('2') != std::string::npos);
}

TEST_CASE("DIGGS: reduced records and odd names come back") {
  const Workplace here;
  write(here / "odd.csv",
        "# [test]\n# name = \"<a> & \\\"b\\\"\"\n# programme = \"CIU\"\n# [specimen]\n"
        "# material = \"<sand>\"\n# void_ratio = 0.7\n# [sensors]\n# axial_strain = \"sound\"\n"
        "# [[stages]]\n# number = 1\n# role = \"shear\"\n# drainage = \"closed\"\n"
        "# control = \"displacement\"\n# strain_path_R = 1\n"
        "axial_strain,deviator_stress_kPa,mean_effective_stress_kPa\n0,0,100\n0.1,5,\n0.2,9,103\n"
        "0.3,9.1,0.1\n");
  check_round_trip((here / "odd.csv").string());
}

TEST_CASE("DIGGS: a test without pore pressure has no shear stage") {
  const Workplace here;
  write(here / "uu.csv",
        "# [test]\n# programme = \"UU\"\naxial_strain,deviator_stress_kPa\n0,0\n0.01,50\n"
        "0.02,80\n0.03,90\n0.04,85\n");
  if (here.triax("replay uu.csv").status != 0) return;
  check_round_trip((here / "uu.csv").string());
}

TEST_CASE("DIGGS: records of others come back") {
  const std::filesystem::path folder = "../shared/data";
  if (!std::filesystem::exists(folder)) {
    std::cout << "skipped: no folder ../shared/data\n";
    return;
  }
  for (const char* const name : {"gds", "kfs", "cyclic"})
    for (const auto& entry : std::filesystem::directory_iterator(folder / name)) {
      const Workplace here;
      const std::string sets = "--set specimen.height_mm=100 --set specimen.diameter_mm=50";
      const auto path = std::filesystem::absolute(entry.path()).string();
      if (!entry.is_regular_file() || here.triax("replay '" + path + "' " + sets).status != 0)
        continue;
      check_round_trip(path, sets);
      break;
    }
}

TEST_CASE("DIGGS: the export is valid") {
  const Workplace here;
  REQUIRE(here.triax("replay " + source("samples/records/icu_6.csv")).status == 0);
  REQUIRE(here.triax("export 1 --format diggs --output one.xml --set SAMP_TOP=4.5 "
                     "--set PROJ_CLNT=A --set LOCA_ID=B")
              .status == 0);
  if (!has_xmllint()) {
    std::cout << "skipped: xmllint is not installed (package libxml2-utils)\n";
    return;
  }
  CHECK(is_valid("--relaxng tests/cli/diggs_export.rng", here / "one.xml"));
  const char* const schema = std::getenv("TRIAX_DIGGS_SCHEMA");
  if (schema == nullptr) {
    std::cout << "skipped: no schema of DIGGS 2.6 (set TRIAX_DIGGS_SCHEMA to its Diggs.xsd)\n";
    return;
  }
  CHECK(is_valid("--schema '" + std::string(schema) + "'", here / "one.xml"));
}

TEST_CASE("DIGGS: one bad test of a file does not stop the others") {
  const Workplace here;
  REQUIRE(here.triax("replay " + source("samples/records/icu_6.csv")).status == 0);
  REQUIRE(here.triax("export 1 --output one.xml").status == 0);
  std::string text = content(here / "one.xml");
  text.insert(text.find("</Diggs>"),
              "<measurement><Test><procedure><TriaxialTest/></procedure></Test></measurement>");
  write(here / "two.xml", text);
  const auto out = here.triax("replay two.xml --db back.db");
  CHECK(out.status == 2);
  CHECK(out.err.find("has no readings, only results") != std::string::npos);
  CHECK(out.err.find("1 of 2 records could not be read") != std::string::npos);
  CHECK(out.out.find("ICU 6") != std::string::npos);
  write(here / "broken.xml", text.substr(0, text.size() / 2));
  const auto broken = here.triax("replay broken.xml --db back.db");
  CHECK(broken.status == 2);
  CHECK(std::count(broken.err.begin(), broken.err.end(), '\n') == 1);
  const auto refused = here.triax("export 1 --output x.xml --set TREG_REM=1");
  CHECK(refused.status == 2);
  CHECK(refused.err.find("not in a DIGGS file; must be one of: PROJ_NAME") != std::string::npos);
  CHECK_FALSE(here.has("x.xml"));
}
