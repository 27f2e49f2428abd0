// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/missing_readings.hpp"

#include <catch2/catch.hpp>

#include "db/connection.hpp"
#include "db/recording/recorder.hpp"
#include "db/store.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using testing::TemporaryFolder;

namespace {

/// Tests 1 and 2 of 30 readings each.
std::string two_whole_tests(const TemporaryFolder& folder) {
  const std::string path = folder.file("t.db");
  for (const char* name : {"a", "b"}) {
    db::Recorder recorder(path);
    const auto listener = recorder.listener();
    listener.started(testing::raw_header(name));
    testing::send_scans(listener, 0, 30);
    lab::TestSummary summary;
    summary.readings = 30;
    recorder.finish(summary);
  }
  return path;
}

}  // namespace

TEST_CASE("missing_readings: none of a whole database, nor of a test that runs") {
  const TemporaryFolder folder;
  const std::string path = two_whole_tests(folder);
  CHECK(db::missing_readings(path).empty());
  CHECK(db::Store(path).load(1).summary.warnings.empty());
  db::open_for_writing(path).exec(
      "UPDATE tests SET readings = NULL, status = 'running' WHERE id = 1");
  CHECK(db::missing_readings(path).empty());
}

TEST_CASE("missing_readings: counts what a test had and the database lacks") {
  const TemporaryFolder folder;
  const std::string path = two_whole_tests(folder);
  db::open_for_writing(path).exec("DELETE FROM scans WHERE id >> 32 = 2 AND id % 3 = 0");
  const auto missing = db::missing_readings(path);
  REQUIRE(missing.size() == 1);
  CHECK(missing[0].test == 2);
  CHECK(missing[0].name == "b");
  CHECK(in_words(missing[0]) == "10 of its 30 readings are missing from the database");
}

TEST_CASE("missing_readings: rows of another test do not make up for them") {
  const TemporaryFolder folder;
  const std::string path = two_whole_tests(folder);
  db::open_for_writing(path).exec(
      "DELETE FROM scans WHERE id = 2 << 32; INSERT INTO scans (id, stage) VALUES ((1 << 32) + 30, "
      "1);"
      "UPDATE tests SET readings = NULL WHERE id = 1");
  CHECK(db::missing_readings(path).size() == 1);
}

TEST_CASE("Store::load: a warning says how many readings are missing") {
  const TemporaryFolder folder;
  const std::string path = two_whole_tests(folder);
  db::open_for_writing(path).exec("DELETE FROM scans WHERE id >> 32 = 2");
  const auto warnings = db::Store(path).load(2).summary.warnings;
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].text.starts_with("30 of its 30 readings are missing"));
}
