// SPDX-License-Identifier: GPL-3.0-or-later
// triax grains: a programme from the command line into files and the database, and what it refuses.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"
#include "tests/cli/running.hpp"
#include "tests/lab/grains/small_programme.hpp"

using namespace triax::cli_tests;
using nlohmann::json;
using triax::test::kSmallGrains;
using triax::test::replaced;

namespace {

int count_of(const Workplace& here, const std::string& counted) {
  const Outcome found =
      here.triax("query \"SELECT count(*) AS n FROM " + counted + "\" --format json");
  REQUIRE(found.status == 0);
  return json::parse(found.out)[0]["n"].get<int>();
}

}  // namespace

TEST_CASE("grains: report, document, files and database tell the same run") {
  const Workplace here;
  write(here / "g.toml", kSmallGrains);
  const Outcome outcome = here.triax("grains g.toml --output out --json");
  CHECK(outcome.status == 0);
  CHECK(outcome.err ==
        "triax: wrote 42 files: out/grains_at_rest.grains to out/grains_load_steps.json\n");
  const json d = json::parse(outcome.out);
  CHECK(d["origin"] == "simulated");
  CHECK(d["stages"].size() == 7);
  CHECK(json::parse(content(here / "out/grains.json")) == d);
  for (const char* file :
       {"at_rest.grains", "drained_points.csv", "probes_probes.csv", "hit_points.csv"}) {
    INFO(file);
    CHECK(here.has(std::string("out/grains_") + file));
  }
  CHECK(count_of(here, "grain_runs WHERE status = 'complete'") == 1);
  CHECK(count_of(here, "grain_stages") == 7);
  CHECK(count_of(here, "grain_probes") == 5);

  // Another thread, and text: the same values.
  const Outcome text = here.triax("grains g.toml --output two --jobs 2 --db b.db");
  CHECK(text.status == 0);
  CHECK_THAT(text.out, Catch::StartsWith("Grains, small (simulated)"));
  const auto works = [&](const std::string& db) {
    return here
        .triax(
            "query \"SELECT number, work_lagrangian_J_per_m3, work_microscopic_J_per_m3, "
            "axial_strain FROM grain_probes\" --format csv --db " +
            db)
        .out;
  };
  CHECK(works("triax.db") == works("b.db"));
}

TEST_CASE("grains: report tells a run from the database as grains told it") {
  const Workplace here;
  write(here / "g.toml", kSmallGrains);
  const Outcome told = here.triax("grains g.toml --output out");
  REQUIRE(told.status == 0);
  const Outcome again = here.triax("report grains:1");
  CHECK(again.status == 0);
  CHECK_THAT(again.out, Catch::EndsWith(told.out));
  CHECK(here.triax("report small").out == again.out);
  CHECK(here.triax("report").out == again.out);

  json document = json::parse(here.triax("report small --format json").out);
  CHECK(document["id"] == 1);
  CHECK(document["status"] == "complete");
  for (const char* of_the_database :
       {"id", "name", "status", "recorded_at", "stored_whole", "last_sign_of_life"})
    document.erase(of_the_database);
  CHECK(document == json::parse(content(here / "out/grains.json")));

  CHECK(here.triax("report small --figures pictures").status == 0);
  CHECK(content(here / "pictures/small_drained.svg") == content(here / "out/grains_drained.svg"));
  REQUIRE(here.triax("report small --format html --output r.html").status == 0);
  CHECK_THAT(content(here / "r.html"), Catch::Contains("<section id=\"grains-1\">") &&
                                           Catch::Contains("SIMULATED") && Catch::Contains("<svg"));
  REQUIRE(here.triax("report small --format pdf --output r.pdf").status == 0);
  CHECK_THAT(content(here / "r.pdf"), Catch::StartsWith("%PDF"));
  const Outcome none = here.triax("report grains:2");
  CHECK(none.status == 2);
  CHECK_THAT(none.err, Catch::Contains("grain run '2' does not exist"));
}

TEST_CASE("grains: a saved state goes on in another programme; --set changes a value") {
  const Workplace here;
  write(here / "g.toml",
        kSmallGrains.substr(0, kSmallGrains.find("[[stages]]\nname = \"probes\"")));
  REQUIRE(here.triax("grains g.toml --output out").status == 0);
  write(here / "p.toml",
        "[run]\nname = \"p\"\n[specimen]\nstate = \"out/grains_at_rest.grains\"\n"
        "[[stages]]\nname = \"probes\"\naction = \"probes\"\ndirections = 4\n");
  const json whole = json::parse(here.triax("grains p.toml --json").out);
  const json fewer =
      json::parse(here.triax("grains p.toml --json --set stages.1.directions=2").out);
  CHECK(count_of(here, "grain_probes WHERE run_id = 2") == 5);
  CHECK(count_of(here, "grain_probes WHERE run_id = 3") == 3);
  CHECK(count_of(here,
                 "grain_probes a JOIN grain_probes b ON a.run_id = 2 AND b.run_id = 3 AND "
                 "a.alpha_deg = b.alpha_deg AND a.axial_strain = b.axial_strain") == 2);
}

TEST_CASE("grains: bad input is one line and status 2, and leaves nothing behind") {
  const Workplace here;
  const auto refused = [&](const std::string& arguments, const std::string& because) {
    const Outcome outcome = here.triax("grains " + arguments);
    INFO(arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.err, Catch::Contains(because));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK_FALSE(here.has("triax.db"));
  };
  write(here / "g.toml", kSmallGrains);
  refused("none.toml", "none.toml");
  refused("g.toml", "--output FOLDER");
  refused("g.toml --output out --set specimen.grains=many", "grains");
  refused("g.toml --output g.toml", "--output g.toml: is a file; expected a folder");
  refused("g.toml --output out --db g.toml", "would be overwritten");
  write(here / "empty.toml", "");
  refused("empty.toml", "run");
  const std::string with_state = "[run]\nname = \"p\"\n[specimen]\nstate = \"s.grains\"\n";
  write(here / "s.toml", with_state);
  refused("s.toml", "s.grains");
  write(here / "s.grains", "no state");
  refused("s.toml", "s.grains");
}

TEST_CASE("grains: stopped by Ctrl-C the stages that ended are there; killed, the run is told so",
          "[slow]") {
  const Workplace here;
  // The last stage alone takes minutes.
  write(here / "g.toml",
        kSmallGrains.substr(0, kSmallGrains.find("[[stages]]\nname = \"at rest\"")) +
            "[[stages]]\nname = \"long\"\naction = \"drained\"\nradial_stress_kPa = 120.0\n"
            "strain_rate_per_s = 1e-5\nend_axial_strain_pct = 5.0\n");
  {
    const Running child(here, "grains g.toml");
    REQUIRE(child.reaches("triax.db", "grain_stages", 1));
    CHECK(child.end_by(SIGINT) == 1);
    CHECK_THAT(child.err(), Catch::Contains("stopped by the operator"));
    CHECK_THAT(child.out(), Catch::Contains("drained"));
  }
  CHECK(count_of(here, "grain_stages") == 2);
  CHECK(count_of(here, "grain_runs WHERE status = 'interrupted'") == 1);
  {
    const Running child(here, "grains g.toml");
    REQUIRE(child.reaches("triax.db", "grain_stages WHERE run_id = 2", 1));
    CHECK(child.end_by(SIGKILL) == -1);
  }
  silence(here / "triax.db");
  CHECK(count_of(here, "seen_grain_runs WHERE status = 'interrupted'") == 2);
  CHECK(here.triax("tests repair").out.find("grain run 2 ") == 0);
  CHECK(count_of(here, "grain_runs WHERE status = 'interrupted'") == 2);
}

TEST_CASE("grains: --merge stores the whole run before a signal ends it") {
  const Workplace here;
  write(here / "g.toml",
        kSmallGrains.substr(0, kSmallGrains.find("[[stages]]\nname = \"probes\"")));
  REQUIRE(here.triax("grains g.toml --output out").status == 0);
  write(here / "p.toml",
        "[run]\nname = \"p\"\n[specimen]\nstate = \"out/grains_at_rest.grains\"\n"
        "[[stages]]\nname = \"probes\"\naction = \"probes\"\ndirections = 4\n");
  REQUIRE(here.triax("grains p.toml --piece 1/2 --output 1.json").status == 0);
  REQUIRE(here.triax("grains p.toml --piece 2/2 --output 2.json").status == 0);

  // The signal comes while the merge waits for the lock of another program, which then ends.
  SQLite::Database other((here / "triax.db").string(), SQLite::OPEN_READWRITE);
  other.exec("BEGIN IMMEDIATE");
  const Running child(here, "grains p.toml --merge 1.json 2.json");
  REQUIRE(child.says("database is locked"));
  std::thread unlock([&other] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    other.exec("ROLLBACK");
  });
  CHECK(child.end_by(SIGINT) == 1);
  unlock.join();
  CHECK_THAT(child.err(), Catch::Contains("stopped by the operator; the run is stored"));
  CHECK(count_of(here, "grain_runs WHERE name = 'p' AND status = 'complete'") == 1);
  CHECK(count_of(here, "grain_probes WHERE run_id = 2") == 5);
}
