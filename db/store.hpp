// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What was measured, in SQLite. All SQL of the project lives in this folder.
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "db/revisions.hpp"
#include "lab/results/forecast.hpp"
#include "lab/results/reading.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/second_order_work_point.hpp"
#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"

namespace SQLite {
class Database;
}

namespace triax::db {

/// As a reader sees it: what runs has given a sign of life lately (db/recording/lease.hpp), what
/// was interrupted ended without a result or has been silent.
enum class TestStatus { running, complete, interrupted };
std::string_view to_string(TestStatus status);
/// What is no status of ours was interrupted.
TestStatus status_of(std::string_view text);

/// Of the writer of what is not complete.
struct SignOfLife {
  std::string at;             ///< the last one, ISO 8601, UTC
  std::int64_t silent_s = 0;  ///< since then
};

/// Which values of a sweep a test was run with.
struct SweepMembership {
  std::string sweep;       ///< name of the sweep, the same for all its tests
  std::int64_t place = 1;  ///< of this test in the order of the sweep
  /// Keys as in the programme's file, in the order they were asked for. A value that is a number is
  /// stored as one.
  std::vector<std::pair<std::string, std::string>> values;
};

struct StoredTest {
  std::int64_t id = 0;
  TestStatus status = TestStatus::running;
  std::optional<SignOfLife> sign_of_life;  ///< empty: complete, or of an older triax
  std::string stored_at;                   ///< when it was imported or simulated, ISO 8601, UTC
  lab::RecordHeader header;
  lab::TestSummary summary;
  std::vector<lab::Event> events;
  std::optional<SweepMembership> sweep;
  std::vector<std::string> tags;  ///< in the order of the alphabet (db/catalogue.hpp sets them)
  /// The state at the reading that the onset names: the onset's own values are fitted to its
  /// surroundings. Empty without an onset.
  std::optional<lab::State> state_at_onset{};
  /// Corrections, oldest first (db/corrections/correction.hpp); all else is of the newest.
  std::vector<Revision> revisions{};
};

/// What tells whether a test is still what it was when something was made of it.
struct TestVersion {
  TestStatus status = TestStatus::running;
  std::string stored_at;  ///< as in StoredTest
  std::string digest;     ///< of the record
  std::int64_t readings = 0;
  std::int64_t revision = 1;
};

/// "test 7 does not exist; ...". Several: "tests 7, 8 do not exist; ...". The rest lists all tests.
std::string describe_missing_tests(const std::vector<std::int64_t>& ids);

/// Reads a database of tests (the Recorder writes it), also while it is written. One thread at a
/// time.
class Store {
 public:
  /// Opens an existing database read only, as open_for_reading() does. Throws lab::BadInput if the
  /// file is missing, is no triax database, or has a newer schema than this program.
  explicit Store(const std::string& path);
  /// Reads through a connection of the newest schema that outlives it; `path` names it in messages.
  Store(const std::string& path, SQLite::Database& database);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// Ids of the tests named by id or name; all, oldest first, if `names` is empty. A name that
  /// stands for several tests means the latest. Where there is no such id or name, case,
  /// underscores for blanks and the words before the last may be left out ("csu_26", "26" for "CSU
  /// 26") as long as one name is meant. Throws lab::BadInput otherwise.
  std::vector<std::int64_t> find(const std::vector<std::string>& names) const;
  /// A warning of the summary says how many readings are missing (db/missing_readings.hpp).
  StoredTest load(std::int64_t id) const;
  /// One row of it, where load() reads all that was said of the test.
  TestVersion version(std::int64_t id) const;

  /// Every scan of a test in order, bit for bit as recorded but for Reading::line, which is not
  /// kept (0); `every` > 1 gives only readings whose number it divides (figures of long tests).
  void for_each_scan(std::int64_t id, std::int64_t every,
                     const std::function<void(const lab::Reading&, const lab::State&)>& use) const;
  /// The scans from reading `from` on, in order: its number and the values of these columns
  /// (db/scans/read_columns.hpp); NaN for what is missing.
  void for_each_row(std::int64_t id, std::int64_t from, std::span<const std::size_t> columns,
                    const std::function<void(std::int64_t, std::span<const double>)>& use) const;
  /// The same of whole scans.
  void for_each_scan_from(
      std::int64_t id, std::int64_t from,
      const std::function<void(const lab::Reading&, const lab::State&)>& use) const;
  /// One scan of it; empty where the test has no such reading.
  std::optional<lab::State> state_at(std::int64_t id, std::int64_t reading) const;
  /// At most `count` readings from reading `from` on, as for_each_scan() gives them.
  std::vector<lab::Reading> readings(std::int64_t id, std::int64_t from, std::int64_t count) const;
  std::int64_t scan_count(std::int64_t id) const;
  std::vector<lab::SecondOrderWorkPoint> second_order_work(std::int64_t id) const;
  /// What the alarm forecast while the test ran, in the order in which it was said.
  std::vector<lab::Forecast> forecasts(std::int64_t id) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace triax::db
