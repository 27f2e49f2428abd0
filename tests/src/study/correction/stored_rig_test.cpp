// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/correction/stored_rig.hpp"

#include <catch2/catch.hpp>

#include "db/recording/recorder.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;

TEST_CASE("StoredRig: gives readings with their lines, and what the rig reported") {
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  constexpr std::int64_t kScans = 5000;  // more than one chunk
  db::Recorder recorder(path);
  const auto listener = recorder.listener();
  auto header = testing::raw_header("a");
  listener.started(header);
  testing::send_scans(listener, 0, kScans);
  listener.happened(
      {.reading = 3, .kind = lab::EventKind::held, .detail = "h", .detected_at = {{3, {}}}});
  listener.happened({.reading = 4, .kind = lab::EventKind::lost, .detail = "found by the session"});
  listener.happened({.reading = 9999, .kind = lab::EventKind::run_away, .detail = "at the end"});
  lab::TestSummary summary;
  summary.readings = kScans;
  summary.warnings = {{2, "of the record"}, {0, "of the reduction"}};
  summary.checks = {{.kind = lab::CheckKind::stage_target}, {.kind = lab::CheckKind::b_value}};
  summary.ending = {.warnings = 1, .cut_short = "why", .stage_lines = {{0, 12}}};
  summary.guard.emplace().done = "hold";
  summary.guard->level = lab::WarningLevel::imminent;
  summary.guard->at.reading = 7;
  summary.truth = lab::Truth{};
  const auto id = recorder.finish(summary);

  const db::Store store(path);
  const auto test = store.load(id);
  db::FirstHeader first;
  first.header = header;
  first.ending = summary.ending;
  study::StoredRig rig(store, test, study::header_to_replay(test, first), *first.ending);
  CHECK(rig.header().cut_short == "why");
  REQUIRE(rig.header().warnings.size() == 1);
  CHECK(rig.header().warnings[0].text == "of the record");
  CHECK(rig.truth());
  REQUIRE(rig.checks().size() == 1);
  CHECK(rig.checks()[0].kind == lab::CheckKind::stage_target);

  lab::Reading reading;
  std::vector<std::int64_t> held, guarded;
  std::int64_t count = 0;
  while (rig.next(reading)) {
    CHECK((reading.line == 12) == (reading.number == 0));
    CHECK_FALSE(rig.guarded());  // asked of the reading before
    if (!rig.events().empty()) held.push_back(reading.number);
    if (rig.guarded()) guarded.push_back(reading.number);
    ++count;
  }
  CHECK(count == kScans);
  CHECK(rig.progress() == 1);
  CHECK(held == std::vector<std::int64_t>{3});
  CHECK(guarded == std::vector<std::int64_t>{7});
  REQUIRE(rig.events().size() == 1);
}
