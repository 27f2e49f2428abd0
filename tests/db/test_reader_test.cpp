// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/test_reader.hpp"

#include <catch2/catch.hpp>

#include "db/connection.hpp"
#include "db/summary_writer.hpp"
#include "db/test_writer.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;

TEST_CASE("a test without summary reads as one of which nothing is known") {
  testing::TemporaryFolder folder;
  SQLite::Database database = db::open_for_writing(folder.file("t.db"));
  lab::RecordHeader header = testing::raw_header("a");
  header.has_time = false;
  header.programme.clear();
  header.columns = {lab::Quantity::axial_strain, lab::Quantity::deviator_stress};
  const db::StoredTest test = db::read_test(database, db::insert_test(database, header, "now"));
  CHECK(test.stored_at == "now");
  CHECK(test.header.columns == header.columns);
  CHECK_FALSE(test.header.has_time);
  CHECK(test.header.programme.empty());
  CHECK_FALSE(test.header.seed);
  CHECK_FALSE(test.summary.peak);
  CHECK_FALSE(test.summary.truth);
  CHECK_FALSE(test.summary.consolidation.b_value);
  CHECK_FALSE(test.summary.collapse.onset);
  CHECK(test.summary.checks.empty());
  CHECK(db::read_test(database, 2).id == 0);
}

TEST_CASE("a kind of event that this version does not know is said, not guessed") {
  testing::TemporaryFolder folder;
  SQLite::Database database = db::open_for_writing(folder.file("t.db"));
  const auto id = db::insert_test(database, testing::raw_header("a"), "now");
  db::insert_event(database, id, {3, 0.3, lab::EventKind::run_away, "it ran"});
  CHECK(db::read_test(database, id).events[0].kind == lab::EventKind::run_away);
  database.exec("UPDATE events SET kind = 'earthquake'");
  CHECK_THROWS_WITH(db::read_test(database, id), Catch::Contains("'earthquake'"));
}

TEST_CASE("cycles of load come back as they were stored, and none where there were none") {
  testing::TemporaryFolder folder;
  SQLite::Database database = db::open_for_writing(folder.file("t.db"));
  const auto id = db::insert_test(database, testing::raw_header("a"), "now");
  lab::TestSummary summary;
  summary.cyclic = lab::CyclicLoading{.cycles = 7.5,
                                      .q_low_pa = -20e3,
                                      .q_high_pa = 25e3,
                                      .stress_ratio = 0.12,
                                      .largest_pore_pressure_ratio = 0.97,
                                      .largest_double_amplitude = 0.04,
                                      .liquefied = {},
                                      .double_amplitude = {}};
  summary.cyclic->liquefied.emplace().instant.reading = 512;
  summary.cyclic->liquefied->cycle = 6;
  summary.collapse.kind = lab::CollapseKind::cyclic_mobility;
  db::insert_summary(database, id, summary);
  const auto stored = db::read_test(database, id).summary;
  CHECK(stored.collapse.kind == lab::CollapseKind::cyclic_mobility);
  REQUIRE(stored.cyclic);
  CHECK(stored.cyclic->cycles == 7.5);
  CHECK(stored.cyclic->q_low_pa == Approx(-20e3));
  CHECK(stored.cyclic->q_high_pa == Approx(25e3));
  CHECK(stored.cyclic->stress_ratio == 0.12);
  CHECK(stored.cyclic->largest_pore_pressure_ratio == 0.97);
  CHECK(stored.cyclic->largest_double_amplitude == 0.04);
  REQUIRE(stored.cyclic->liquefied);
  CHECK(stored.cyclic->liquefied->instant.reading == 512);
  CHECK(stored.cyclic->liquefied->cycle == 6);
  CHECK_FALSE(stored.cyclic->double_amplitude);

  const auto monotonic = db::insert_test(database, testing::raw_header("b"), "now");
  db::insert_summary(database, monotonic, {});
  CHECK_FALSE(db::read_test(database, monotonic).summary.cyclic);
}

TEST_CASE("what a guard did comes back as it was stored, with and without the test without it") {
  testing::TemporaryFolder folder;
  SQLite::Database database = db::open_for_writing(folder.file("t.db"));
  const auto id = db::insert_test(database, testing::raw_header("a"), "now");
  lab::TestSummary summary;
  lab::GuardOutcome& guard = summary.guard.emplace();
  guard.level = lab::WarningLevel::lost;
  guard.done = "safe state";
  guard.at = {
      .reading = 51, .time_s = 102.0, .axial_strain = 0.003, .q_pa = 42e3, .p_eff_pa = 80e3};
  guard.second_order_work_normalised = 0.12;
  guard.last_axial_strain = 0.023;
  db::insert_summary(database, id, summary);
  const auto alone = db::read_test(database, id).summary.guard;
  REQUIRE(alone);
  CHECK(alone->level == lab::WarningLevel::lost);
  CHECK(alone->done == "safe state");
  CHECK(alone->at.reading == 51);
  CHECK(alone->at.time_s == 102);
  CHECK(alone->at.axial_strain == 0.003);
  CHECK(*alone->at.q_pa == Approx(42e3));
  CHECK(*alone->at.p_eff_pa == Approx(80e3));
  CHECK(alone->second_order_work_normalised == 0.12);
  CHECK(alone->last_axial_strain == 0.023);
  CHECK_FALSE(alone->without);

  guard.without = {
      .kind = lab::CollapseKind::flow, .last_axial_strain = 0.168, .lost = lab::Moment{60, 120.0}};
  const auto other = db::insert_test(database, testing::raw_header("b"), "now");
  db::insert_summary(database, other, summary);
  const auto both = db::read_test(database, other).summary.guard;
  REQUIRE(both->without);
  CHECK(both->without->kind == lab::CollapseKind::flow);
  CHECK(both->without->last_axial_strain == 0.168);
  REQUIRE(both->without->lost);
  CHECK(both->without->lost->reading == 60);
  CHECK(both->without->lost->time_s == 120);
}
