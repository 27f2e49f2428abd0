// SPDX-License-Identifier: GPL-3.0-or-later
// AGS4 files in a replay: results without readings, stored as reference values.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace triax::cli_tests;
using nlohmann::json;

namespace {

const std::string kCount =
    "query \"SELECT count(*) AS n FROM reference_results\" --format json --db ";

void copy_sample(const Workplace& here, const std::string& name) {
  write(here / name, content("samples/records/results.ags"));
}

int stored_in(const Workplace& here, const std::string& db) {
  return json::parse(here.triax(kCount + db).out)[0]["n"].get<int>();
}

}  // namespace

TEST_CASE("replay says what an AGS4 file is, and its results are asked for by name") {
  const Workplace here;
  copy_sample(here, "results.ags");
  const Outcome told = here.triax("replay results.ags");
  CHECK(told.status == 0);
  CHECK(told.err.empty());
  CHECK(told.out == content("tests/cli/golden/replay_ags4.txt"));
  REQUIRE(here.triax("replay ./results.ags").status == 0);
  CHECK(stored_in(here, "triax.db") == 5);  // replaced, not added
  const json rows = json::parse(here.triax("query reference_results --format json").out);
  REQUIRE(rows.size() == 5);
  CHECK(rows[4]["location"] == "BH9");
  CHECK(rows[4]["q_kPa"] == 424.0);
}

TEST_CASE("an AGS4 file as JSON, alone and beside a record") {
  const Workplace here;
  copy_sample(here, "results.ags");
  write(here / "bare.csv",
        "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n0,0,100\n0.1,5,101\n0.2,9,"
        "103\n");
  const json alone = json::parse(here.triax("replay results.ags --json").out);
  CHECK(alone["what"] == "AGS4 results without readings, nothing to assess; 5 triaxial results");
  CHECK(alone["reference_results"][3]["at_failure"]["s_eff_kPa"] == 395.0);
  const Outcome both = here.triax("replay results.ags bare.csv --json --db both.db");
  INFO(both.err);
  REQUIRE(both.status == 0);
  const json documents = json::parse(both.out);
  REQUIRE(documents.size() == 2);
  CHECK(documents[0]["test"]["name"] == "bare");
  CHECK(documents[1] == alone);
  const std::string text = here.triax("replay results.ags bare.csv --db text.db").out;
  CHECK(text.find("\n\nresults.ags: AGS4 results") != std::string::npos);
}

TEST_CASE("AGS4 without triaxial results, or broken, is status 2 and leaves no database") {
  const Workplace here;
  write(here / "hole.ags",
        "\"GROUP\",\"LOCA\"\r\n\"HEADING\",\"LOCA_ID\"\r\n\"UNIT\",\"\"\r\n\"TYPE\",\"ID\"\r\n"
        "\"DATA\",\"BH1\"\r\n");
  const Outcome none = here.triax("replay hole.ags");
  CHECK(none.status == 2);
  CHECK(none.err.find("hole.ags: AGS4 without a triaxial result: it has the groups LOCA") !=
        std::string::npos);
  write(here / "open.ags", "\"GROUP\",\"TRIT\"\r\n\"HEADING\",\"LOCA_ID\r\n");
  CHECK(here.triax("replay open.ags").err.find("open.ags:2: the quote of cell 2 is not closed") !=
        std::string::npos);
  CHECK_FALSE(here.has("triax.db"));

  copy_sample(here, "results.ags");
  const Outcome mixed = here.triax("replay hole.ags results.ags");
  CHECK(mixed.status == 2);
  CHECK(mixed.out.find("5 triaxial results") != std::string::npos);
  CHECK(stored_in(here, "triax.db") == 5);
}
