// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/query.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

#include "db/connection.hpp"
#include "db/recording/recorder.hpp"
#include "db/store.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using Catch::Matchers::Contains;
using testing::TemporaryFolder;

namespace {

struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<db::Value>> rows;
};

Table ask(const std::string& path, const std::string& question) {
  Table table;
  db::query(
      path, question, [&](const std::vector<std::string>& names) { table.columns = names; },
      [&](const std::vector<db::Value>& values) { table.rows.push_back(values); });
  return table;
}

db::Value answer(const std::string& path, const std::string& question) {
  return ask(path, question).rows.at(0).at(0);
}

/// Test 26 of the database, collapsed, with scans that the tests can compute.
std::string record_collapse(const TemporaryFolder& folder, lab::Origin origin) {
  const std::string path = folder.file("t.db");
  db::Recorder recorder(path);
  const lab::SessionListener listener = recorder.listener();
  lab::RecordHeader header = testing::raw_header("26");
  header.programme = "CSU";
  header.origin = origin;
  listener.started(header);
  testing::send_scans(listener, 0, 100);
  lab::TestSummary summary;
  summary.consolidation = {300e3, 0.97, 0.871, {}, {}};
  summary.collapse.kind = lab::CollapseKind::flow;
  summary.collapse.inside_limit_surface = true;
  summary.collapse.onset = lab::Instant{50, 5.0, 0.005, 56e3, 100e3, 500e3};
  summary.readings = 100;
  recorder.finish(summary);
  return path;
}

}  // namespace

TEST_CASE("collapse_points has the columns of the paper's table") {
  TemporaryFolder folder;
  const Table table = ask(record_collapse(folder, lab::Origin::simulated), "collapse_points");
  CHECK(table.columns == std::vector<std::string>{"type_of_test", "test", "p0_eff_kPa",
                                                  "void_ratio", "phi_mob_deg", "eta", "eta_low",
                                                  "eta_high", "kind", "inside_limit_surface",
                                                  "origin", "test_id"});
  REQUIRE(table.rows.size() == 1);
  const auto& row = table.rows[0];
  CHECK(std::get<std::string>(row[0]) == "CSU");
  CHECK(std::get<double>(row[2]) == 300);
  CHECK(std::get<double>(row[3]) == 0.871);
  CHECK(std::get<double>(row[4]) == Approx(14.84).margin(0.01));  // sin φ = 3·0.56/6.56
  CHECK(std::get<double>(row[5]) == Approx(0.56));
  CHECK(std::get<std::string>(row[10]) == "simulated");
}

TEST_CASE(
    "queries that compare or average tests count a file once, by its latest complete reading") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  const auto record = [&](const std::string& digest, double q_pa, bool complete) {
    db::Recorder recorder(path);
    const lab::SessionListener listener = recorder.listener();
    lab::RecordHeader header = testing::raw_header("r");
    header.digest = digest;
    listener.started(header);
    testing::send_scans(listener, 0, 2);
    lab::TestSummary summary;
    summary.collapse.kind = lab::CollapseKind::flow;
    summary.collapse.onset = lab::Instant{1, 0.1, 0.005, q_pa, 100e3, {}};
    if (complete) recorder.finish(summary);
  };
  record("aa", 90e3, true);  // read again
  record("", 50e3, true);    // simulated: from no file
  record("aa", 60e3, true);  // counts
  record("", 50e3, true);
  record("aa", 10e3, false);  // interrupted: says nothing
  const auto count = [&](const std::string& from) {
    return std::get<std::int64_t>(answer(path, "SELECT count(*) FROM " + from));
  };
  CHECK(count("counted_tests") == 3);
  CHECK(count("collapse_points") == 3);
  CHECK(count("collapses") == 4);  // lists the result of every test
  const Table line = ask(path, "instability_line");
  REQUIRE(line.rows.size() == 1);
  CHECK(line.rows[0][1] == db::Value("compression"));
  CHECK(std::get<std::int64_t>(line.rows[0][4]) == 3);
  CHECK(std::get<double>(line.rows[0][5]) == Approx((0.5 + 0.6 + 0.5) / 3));
  CHECK(std::get<double>(line.rows[0][7]) == Approx(0.6));
  CHECK(answer(path, "SELECT group_concat(test_id) FROM counted_tests") == db::Value("2,3,4"));
  record("bb", 10e3, false);
  record("bb", 10e3, false);
  CHECK(answer(path, "SELECT max(test_id) FROM counted_tests") == db::Value(std::int64_t{7}));
  CHECK(count("counted_tests") == 4);
}

TEST_CASE("every named query runs, gives columns and says what it is for") {
  TemporaryFolder folder;
  const std::string path = record_collapse(folder, lab::Origin::recorded);
  for (const db::NamedQuery& query : db::named_queries()) {
    INFO(query.name);
    CHECK_FALSE(ask(path, std::string(query.name)).columns.empty());
    CHECK(query.purpose.size() > 20);
    CHECK(query.purpose.find('\n') == std::string_view::npos);
  }
}

TEST_CASE("views give units of the field and what follows from the stored values") {
  TemporaryFolder folder;
  const std::string path = record_collapse(folder, lab::Origin::recorded);
  std::mt19937_64 random(0);
  for (int i = 0; i < 7; ++i) testing::raw_scan(random, i);
  const auto [reading, state] = testing::raw_scan(random, 7);
  const auto of_state = [&](const std::string& column) {
    return std::get<double>(
        answer(path, "SELECT " + column + " FROM states WHERE test = '26' AND reading = 7"));
  };
  CHECK(of_state("q_kPa") == Approx(state.q / 1e3));
  CHECK(of_state("p_eff_kPa") == Approx(state.p_eff / 1e3));
  CHECK(of_state("effective_axial_stress_kPa") == Approx(state.effective_stress.axial / 1e3));
  CHECK(of_state("effective_radial_stress_kPa") == Approx(state.effective_stress.radial / 1e3));
  CHECK(of_state("pore_pressure_kPa") == Approx(state.pore_pressure / 1e3));
  CHECK(of_state("radial_strain") == Approx(state.strain.radial));
  CHECK(of_state("shear_strain") == Approx(sim::shear_strain(state.strain)));
  CHECK(of_state("void_ratio") == Approx(state.void_ratio));
  CHECK(of_state("current_area_mm2") == Approx(state.area_m2 * 1e6));
  CHECK(of_state("eta") == Approx(state.eta()));
  CHECK(of_state("phi_mob_deg") == Approx(sim::degrees(state.phi_mob_rad())));
  CHECK(std::get<double>(answer(path,
                                "SELECT cell_pressure_kPa FROM readings WHERE test_id = 1 AND "
                                "reading = 7")) ==
        Approx(reading[lab::Quantity::cell_pressure] / 1e3));
  CHECK(std::holds_alternative<std::monostate>(
      answer(path, "SELECT cell_volume_mm3 FROM readings LIMIT 1")));
}

TEST_CASE(
    "a forecast stands beside the reading after which it was made, with what the onset came to") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  db::Recorder recorder(path);
  const lab::SessionListener listener = testing::start_test(recorder);
  const lab::Forecast said{
      7,    0.7,  0.61,
      0.58, 0.64, lab::LeftToOnset{lab::Quantity::mean_effective_stress, 3.2e3, 12.5}};
  listener.foreseen(said);
  listener.happened({7, 0.7, lab::EventKind::imminent, "soon", lab::Moment{8, 0.8}});
  lab::TestSummary summary;
  summary.collapse.kind = lab::CollapseKind::flow;
  summary.collapse.imminent = said;
  summary.collapse.onset = lab::Instant{9, 0.9, 0.005, 60e3, 100e3, {}};
  recorder.finish(summary);
  const auto number = [&](const std::string& what, const std::string& from) {
    return std::get<double>(answer(path, "SELECT " + what + " FROM " + from));
  };
  CHECK(number("eta_forecast", "forecasts WHERE reading = 7") == 0.61);
  CHECK(number("left_value", "forecasts") == Approx(3.2));
  CHECK(number("eta", "forecasts") == number("eta", "states WHERE reading = 7"));
  const Table alarms = ask(path, "alarms");
  REQUIRE(alarms.rows.size() == 1);
  CHECK(std::get<double>(alarms.rows[0].back()) == Approx(0.6));
  const Table events = ask(path, "events");
  REQUIRE(events.rows.size() == 1);
  CHECK(events.columns[6] == "detected_at_reading");
  CHECK(std::get<std::int64_t>(events.rows[0][6]) == 8);
}

TEST_CASE("alarms: a cyclic warning has a probability and no η", "[db][cyclic]") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  db::Recorder recorder(path);
  testing::start_test(recorder);
  lab::Forecast warned{.reading = 7, .time_s = 0.7};
  warned.eta = warned.eta_low = warned.eta_high = lab::kMissing;
  warned.cyclic = lab::CyclicForecast{0.75, 4.5};
  lab::TestSummary summary;
  summary.collapse.imminent = warned;
  recorder.finish(summary);
  CHECK(std::get<double>(answer(path, "SELECT failure_probability FROM outlooks")) == 0.75);
  CHECK(std::holds_alternative<std::monostate>(answer(path, "SELECT eta_forecast FROM outlooks")));
  const auto stored = db::Store(path).load(1);
  REQUIRE(stored.summary.collapse.imminent);
  REQUIRE(stored.summary.collapse.imminent->cyclic);
  CHECK(stored.summary.collapse.imminent->cyclic->load_cycles == 4.5);
  CHECK(std::isnan(stored.summary.collapse.imminent->eta));
}

TEST_CASE("a filter on a test is a range of rows, not a scan of the table") {
  TemporaryFolder folder;
  const std::string path = record_collapse(folder, lab::Origin::recorded);
  for (const char* question :
       {"EXPLAIN QUERY PLAN SELECT * FROM readings WHERE test_id = 3",
        "EXPLAIN QUERY PLAN SELECT * FROM states WHERE test_id = 3",
        "EXPLAIN QUERY PLAN SELECT eta FROM states WHERE test = '26'",
        "EXPLAIN QUERY PLAN SELECT * FROM second_order_work WHERE test_id = 3",
        "EXPLAIN QUERY PLAN SELECT * FROM forecasts WHERE test_id = 3"}) {
    std::string plan;
    for (const auto& row : ask(path, question).rows) plan += std::get<std::string>(row[3]) + '\n';
    INFO(question << "\n" << plan);
    CHECK_THAT(plan, Contains("USING INTEGER PRIMARY KEY (rowid>? AND rowid<?)"));
    CHECK_THAT(plan, !Contains("SCAN"));
  }
}

TEST_CASE("SQLite itself refuses to write") {
  TemporaryFolder folder;
  const std::string path = record_collapse(folder, lab::Origin::recorded);
  for (const std::string& sql :
       {std::string("INSERT INTO tests (name) VALUES ('x')"), std::string("DELETE FROM scans"),
        std::string("UPDATE tests SET name = 'x'"), std::string("CREATE TABLE x (y)"),
        std::string("CREATE TEMP TABLE x (y)"), std::string("DROP VIEW states"),
        std::string("PRAGMA user_version = 9"), std::string("PRAGMA user_version = -0x9"),
        std::string("PRAGMA page_size(512)"), std::string("PRAGMA query_only = 0"),
        std::string("PRAGMA journal_mode = DELETE"), std::string("PRAGMA wal_checkpoint"),
        std::string("BEGIN IMMEDIATE"), std::string("DETACH DATABASE main"), std::string("VACUUM"),
        "ATTACH DATABASE '" + folder.file("other.db") + "' AS other",
        "VACUUM INTO '" + folder.file("other.db") + "'",
        std::string("WITH x AS (SELECT 1) INSERT INTO scans (id, stage) SELECT 1, 1 FROM x"),
        std::string("SELECT load_extension('x')")}) {
    INFO(sql);
    CHECK_THROWS_AS(ask(path, sql), lab::BadInput);
  }
  CHECK_FALSE(std::filesystem::exists(folder.file("other.db")));
  CHECK(std::get<std::int64_t>(answer(path, "SELECT count(*) FROM scans")) == 100);
  CHECK(std::get<std::int64_t>(answer(path, "PRAGMA user_version")) == db::newest_schema());
  CHECK(std::get<std::string>(answer(path, "PRAGMA integrity_check")) == "ok");
  CHECK(ask(path, "PRAGMA table_info(tests)").rows.size() == 14);
}

TEST_CASE("SQL that cannot be run says why in SQLite's words") {
  TemporaryFolder folder;
  const std::string path = record_collapse(folder, lab::Origin::recorded);
  CHECK_THROWS_WITH(ask(path, "SELECT no_such_thing FROM tests"),
                    Contains("no such column: no_such_thing"));
  CHECK_THROWS_WITH(ask(path, "SELEC 1"), Contains("near \"SELEC\": syntax error"));
  CHECK_THROWS_WITH(ask(path, "SELECT 1; SELECT 2"), Contains("more than one statement"));
  CHECK_THROWS_WITH(ask(path, "SELECT 1; nonsense"), Contains("more than one statement"));
  CHECK_THROWS_WITH(ask(path, " ; -- nothing"), Contains("no statement"));
  CHECK_THROWS_WITH(ask(path, "collapse_point"),
                    Contains("unknown query 'collapse_point'; did you mean 'collapse_points'?"));
  CHECK(std::get<std::int64_t>(answer(path, "SELECT 1 ; -- one")) == 1);
}

TEST_CASE("a database that is missing says how one comes about, and is not made") {
  TemporaryFolder folder;
  CHECK_THROWS_WITH(ask(folder.file("none.db"), "tests"),
                    Contains("none.db") && Contains("triax replay"));
  CHECK(folder.is_empty());
}

TEST_CASE("a damaged database is failed work, not a bad question") {
  TemporaryFolder folder;
  const std::string path = record_collapse(folder, lab::Origin::recorded);
  const auto page = std::get<std::int64_t>(
      answer(path, "SELECT rootpage FROM sqlite_schema WHERE name = 'scans'"));
  const auto size = std::get<std::int64_t>(answer(path, "PRAGMA page_size"));
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp((page - 1) * size);
    file << std::string(static_cast<std::size_t>(size), '\xff');
  }
  CHECK_THROWS_AS(ask(path, "SELECT * FROM scans"), lab::WorkFailed);
  CHECK_THROWS_AS(ask(path, "SELECT nothing FROM scans"), lab::BadInput);
}

TEST_CASE("query: ends what computes for longer than its limit") {
  const TemporaryFolder folder;
  const std::string path = record_collapse(folder, lab::Origin::recorded);
  const std::string endless =
      "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT count(*) FROM n";
  const auto ask_for = [&](double seconds) {
    db::query(
        path, endless, [](const auto&) {}, [](const auto&) {}, seconds);
  };
  CHECK_THROWS_AS(ask_for(0.05), lab::WorkFailed);
  CHECK_THROWS_WITH(ask_for(0.05), Contains("within 0.05 s") && Contains("--time-limit"));
}

TEST_CASE("query: the time that its rows are used for does not count") {
  const TemporaryFolder folder;
  const std::string path = record_collapse(folder, lab::Origin::recorded);
  std::int64_t rows = 0;
  db::query(
      path, "SELECT a.id FROM scans a, scans b", [](const auto&) {},
      [&](const auto&) {
        if (++rows % 1000 == 1) std::this_thread::sleep_for(std::chrono::milliseconds(100));
      },
      0.9);
  CHECK(rows == 10000);
}
