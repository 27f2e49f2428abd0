// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/corrections/correction.hpp"

#include <catch2/catch.hpp>

#include "db/connection.hpp"
#include "db/recording/recorder.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using Catch::Contains;

namespace {

/// A complete test of `scans` readings; gives its id.
std::int64_t record(const std::string& path, std::int64_t scans) {
  db::Recorder recorder(path);
  const auto listener = recorder.listener();
  lab::RecordHeader header = testing::raw_header("a");
  header.warnings = {{1, "of the record"}};
  listener.started(header);
  testing::send_scans(listener, 0, scans);
  listener.happened({1, 0.5, lab::EventKind::limit_surface, "first"});
  lab::TestSummary summary;
  summary.readings = scans;
  summary.warnings = {{1, "of the record"}, {0, "of the reduction"}};
  summary.ending.warnings = 1;
  summary.collapse.kind = lab::CollapseKind::flow;
  summary.truth = lab::Truth{.lost_sustainability = true};
  return recorder.finish(summary);
}

/// All bits of the readings of a test.
std::vector<double> readings_of(const std::string& path, std::int64_t id) {
  std::vector<double> values;
  db::Store(path).for_each_scan(id, 1, [&](const lab::Reading& reading, const lab::State&) {
    values.push_back(reading.time_s);
    for (const double value : reading.si) values.push_back(std::isnan(value) ? -1 : value);
  });
  return values;
}

void correct(db::Correction& correction, std::int64_t scans, const char* event) {
  const auto listener = correction.listener();
  lab::RecordHeader header = correction.test().header;
  header.specimen.height_m = 0.15;
  header.name = "renamed";
  listener.started(header);
  for (const lab::Reading& reading :
       correction.readings().readings(correction.test().id, 0, scans)) {
    lab::State state;
    state.reading = reading.number;
    state.stage = reading.stage;
    state.q = 7;
    listener.scanned(reading, state);
  }
  listener.happened({2, 0.5, lab::EventKind::limit_surface, event});
}

}  // namespace

TEST_CASE("Correction: replaces the results and keeps readings, id, warnings and truth") {
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  const auto id = record(path, 3);
  const auto before = readings_of(path, id);
  lab::TestSummary summary;
  summary.readings = 3;
  summary.collapse.kind = lab::CollapseKind::limited;
  {
    db::Correction correction(path, id);
    CHECK(correction.is_exact());
    CHECK(correction.first().ending->warnings == 1);
    CHECK_FALSE(correction.stages().empty());
    correct(correction, 3, "second");
    CHECK(db::Store(path).load(id).events.at(0).detail == "first");  // others still see the old one
    CHECK(correction.commit(summary, {{"specimen.height_mm", "140", "150"}}) == 2);
  }
  const db::Store store(path);
  const db::StoredTest test = store.load(id);
  CHECK(readings_of(path, id) == before);
  CHECK(test.header.name == "renamed");
  CHECK(*test.header.specimen.height_m == Approx(0.15));
  REQUIRE(test.events.size() == 1);
  CHECK(test.events[0].detail == "second");
  CHECK(test.summary.collapse.kind == lab::CollapseKind::limited);
  CHECK(test.summary.truth->lost_sustainability);
  CHECK(test.summary.warnings.empty());
  CHECK(test.header.warnings.at(0).text == "of the record");
  CHECK(store.state_at(id, 2)->q == 7);
  REQUIRE(test.revisions.size() == 1);
  CHECK(test.revisions[0].former_kind == lab::CollapseKind::flow);
}

TEST_CASE("Correction: without a commit the test is as it was") {
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  const auto id = record(path, 25'000);
  const auto before = readings_of(path, id);
  {
    db::Correction correction(path, id);
    correct(correction, 25'000, "second");
  }
  CHECK(readings_of(path, id) == before);
  const auto test = db::Store(path).load(id);
  CHECK(test.events.at(0).detail == "first");
  CHECK(test.summary.collapse.kind == lab::CollapseKind::flow);
  CHECK(test.revisions.empty());
}

TEST_CASE("Correction: refuses tests that run, were interrupted, are leased or missing") {
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  CHECK_THROWS_AS(db::Correction(path, 1), lab::BadInput);
  const auto id = record(path, 3);
  CHECK_THROWS_WITH(db::Correction(path, 77), Contains("test 77 does not exist"));
  {
    auto database = db::open_for_writing(path);
    database.exec(
        "INSERT INTO leases (writer, test_id, last_sign_of_life) VALUES ('w', 1, "
        "strftime('%Y-%m-%dT%H:%M:%SZ', 'now'))");
  }
  CHECK_THROWS_WITH(db::Correction(path, id), Contains("nothing was changed"));
  db::open_for_writing(path).exec("UPDATE tests SET status = 'running'");
  CHECK_THROWS_WITH(db::Correction(path, id), Contains("still being recorded"));
  db::open_for_writing(path).exec("DELETE FROM leases");
  CHECK_THROWS_WITH(db::Correction(path, id), Contains("interrupted"));
  db::open_for_writing(path).exec("UPDATE tests SET status = 'complete'");
  db::open_for_writing(path).exec("DELETE FROM scans WHERE id & 4294967295 = 1");
  CHECK_THROWS_WITH(db::Correction(path, id), Contains("readings are missing"));
}

TEST_CASE("Correction: a test of an older triax starts from what is stored") {
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  const auto id = record(path, 3);
  db::open_for_writing(path).exec("DELETE FROM first_headers");
  const db::Correction correction(path, id);
  CHECK_FALSE(correction.is_exact());
  CHECK(correction.first().ending->warnings == 1);
  CHECK(*correction.first().header.specimen.height_m == Approx(0.14));
}
