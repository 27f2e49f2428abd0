// SPDX-License-Identifier: GPL-3.0-or-later
// triax export from outside: what a laboratory hands over.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace triax::cli_tests;

namespace {

/// Records of the folder that lie beside the checkout; the samples alone where there is none.
std::vector<std::filesystem::path> records() {
  std::vector<std::filesystem::path> out;
  for (const char* const folder : {"samples/records", "../shared/data"}) {
    if (!std::filesystem::exists(folder)) {
      std::cout << "skipped: no folder " << folder << '\n';
      continue;
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (const auto ending = entry.path().extension();
          ending == ".csv" || ending == ".dat" || ending == ".gds")
        out.push_back(std::filesystem::absolute(entry.path()));
  }
  return out;
}

}  // namespace

TEST_CASE("a record goes out as CSV and comes back, reading by reading") {
  const Workplace here;
  REQUIRE(here.triax("replay " + source("samples/records/icu_6.csv")).status == 0);
  const auto out = here.triax("export 1 --format csv --output back.csv");
  CHECK(out.status == 0);
  CHECK(out.err == "triax: wrote back.csv\n");
  REQUIRE(here.triax("replay back.csv").status == 0);
  REQUIRE(here.triax("export 1 --states --output one.csv --format csv").status == 0);
  REQUIRE(here.triax("export 2 --states --output two.csv --format csv").status == 0);
  CHECK(content(here / "one.csv") == content(here / "two.csv"));
  CHECK(content(here / "one.csv").starts_with("reading,time_s,stage,axial_strain,"));
}

TEST_CASE("no cell of an exported CSV is a formula to a spreadsheet") {
  const Workplace here;
  write(here / "evil.csv",
        "# [test]\n# name = \"a, =1+1;@x\\t-2|+3\"\n# [specimen]\n# material = \"=HYPERLINK(1)\"\n"
        "axial_strain,deviator_stress_kPa,mean_effective_stress_kPa\n0,0,100\n0.1,5,101\n0.2,-9,"
        "103\n");
  REQUIRE(here.triax("replay evil.csv").status == 0);
  for (const std::string states : {"", " --states"}) {
    REQUIRE(here.triax("export 1 --format csv --output out.csv" + states).status == 0);
    std::string cell;
    for (const char c : content(here / "out.csv") + "\n") {
      if (std::string(",;|\t\r\n").find(c) == std::string::npos) {
        cell += c;
        continue;
      }
      const auto begin = cell.find_first_not_of(" \"");
      if (begin != std::string::npos) {
        const bool formula = std::string("=+-@").find(cell[begin]) != std::string::npos;
        char* end = nullptr;
        std::strtod(cell.c_str(), &end);
        INFO(cell);
        CHECK((!formula || *end == 0));
      }
      cell.clear();
    }
  }
  REQUIRE(here.triax("export 1 --format csv --output back.csv").status == 0);
  REQUIRE(here.triax("replay back.csv").status == 0);
  const auto report = nlohmann::json::parse(here.triax("report 2 --format json").out);
  CHECK(report["test"]["name"] == "a, =1+1;@x\t-2|+3");
}

TEST_CASE("JSON holds the report with readings and states") {
  const Workplace here;
  REQUIRE(here.triax("replay " + source("samples/records/icu_6.csv")).status == 0);
  const auto out = here.triax("export --format json");
  CHECK(out.status == 0);
  const auto document = nlohmann::json::parse(out.out);
  const auto report = nlohmann::json::parse(here.triax("report --format json").out);
  CHECK(document["collapse"] == report["collapse"]);
  CHECK(document["readings"]["columns"][0] == "time_s");
  CHECK(document["states"]["rows"].size() == 3280);
  CHECK(document["states"]["rows"][0].size() == document["states"]["columns"].size());
}

TEST_CASE("every record goes out as AGS4 without a finding, ours or python-ags4's") {
  const Workplace here;
  for (const auto& record : records()) {
    INFO(record);
    const auto replayed =
        here.triax("replay '" + record.string() + "' --set specimen.height_mm=100 " +
                   "--set specimen.diameter_mm=50");
    CHECK(replayed.status == 0);
  }
  const auto out = here.triax("export --format ags --output all.ags");
  CHECK(out.status == 0);
  CHECK(here.triax("export --check all.ags").status == 0);
  // Only results are read back, of what was exported as they were.
  CHECK(here.triax("replay all.ags").status == 0);
  const std::string checker = "../shared/tools/ags4check";
  if (!std::filesystem::exists(checker) ||
      std::system("/usr/bin/python3 -c 'import pandas, rich' 2>/dev/null") != 0) {
    std::cout << "skipped: no python-ags4 beside the checkout\n";
    return;
  }
  CHECK(std::system((checker + " '" + (here / "all.ags").string() + "' >/dev/null").c_str()) == 0);
}

TEST_CASE("what cannot be exported is one line and status 2") {
  const Workplace here;
  REQUIRE(here.triax("replay " + source("samples/records/icu_6.csv")).status == 0);
  write(here / "broken.ags", "\"GROUP\",\"PROJ\"\r\n");
  for (const char* const arguments :
       {"export 1", "export 1 --output x.doc", "export 1 --format csv --set LOCA_ID=1",
        "export 1 --format ags --set LOCA_XX=1", "export 1 --format ags --set SAMP_TOP=deep",
        "export 1 --format json --states", "export 1 --format csv --output triax.db",
        "export 7 --format csv", "export 1 --format csv --output -", "export --check none.ags"}) {
    const auto out = here.triax(arguments);
    INFO(arguments << '\n' << out.err);
    CHECK(out.status == 2);
    CHECK(std::count(out.err.begin(), out.err.end(), '\n') == 1);
  }
  CHECK(here.triax("export --check broken.ags").status == 2);
  CHECK_FALSE(here.has("LOCA"));
}
