// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One test on its way into one database.
#include <SQLiteCpp/Database.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "db/files/created_file.hpp"
#include "db/files/open_files.hpp"
#include "db/recording/lease.hpp"
#include "db/scan_writer.hpp"
#include "db/store.hpp"
#include "lab/warning/earlier_tests.hpp"

namespace triax::db {

/// What a session told since the batch before.
struct Batch {
  std::vector<Scan> scans;
  std::vector<lab::SecondOrderWorkPoint> work;
  std::vector<lab::Forecast> forecasts;
  std::vector<lab::Event> events;

  std::size_t rows() const { return scans.size() + work.size() + forecasts.size() + events.size(); }
  void clear();
};

/// What is known of a test when it starts.
struct TestStart {
  lab::RecordHeader header;
  std::string stored_at;  ///< ISO 8601, UTC
  std::optional<SweepMembership> sweep;
  lab::EarlierTests earlier{};  ///< that the alarm knows
};

/// Enters the database with its first batch, and holds the lease of the test from then on. Each
/// function is one transaction, all or nothing, and may be called again after a failure. They throw
/// MayPass for a lock or a full disk, lab::WorkFailed or lab::BadInput for what stays. One thread
/// at a time.
class TestEntry {
 public:
  /// A lock is waited for as long as `patience`; the file does not grow beyond `most_bytes`, where
  /// they are not 0.
  TestEntry(std::string path, std::chrono::milliseconds patience, std::int64_t most_bytes = 0);
  /// Continues the test of `writer` if it is in the database; otherwise begins one of that writer.
  TestEntry(std::string path, std::chrono::milliseconds patience, std::string writer);

  const std::string& path() const { return path_; }
  /// 0 before the test is there.
  std::int64_t id() const { return id_; }
  const Lease& lease() const { return lease_; }

  void store(const TestStart& test, const Batch& batch);
  /// The last batch, and the summary.
  void complete(const TestStart& test, const Batch& batch, const lab::TestSummary& summary);
  /// The last batch; the test ends without a result.
  void interrupt(const TestStart& test, const Batch& batch);
  /// The readings, second-order work and events of the test `id` of another database that are not
  /// there yet, in several transactions.
  void take_in(const TestStart& test, const Store& from, std::int64_t id);
  /// All of the test as it is here into `other`.
  void copy_into(TestEntry& other, const TestStart& test);

  /// Throws FilesMoved where the files of the database are no longer in place. What is committed
  /// stays readable for this entry, until abandon().
  void check_files() const;
  /// Of files that have moved: the path is in their folder today, which may have been renamed.
  void find_folder() { path_ = files_->path_today(); }
  /// Lets go of files that have moved. The next transaction looks for the database at its path and
  /// goes on with the test where it is there.
  void abandon();
  /// A database that is not at its path after abandon() is created again. Without this call
  /// transactions throw MayPass until it is there; NotInPlace where something else is.
  void make_anew() { may_make_ = true; }
  /// From the next transaction on.
  void set_patience(std::chrono::milliseconds patience);
  /// A sign of life where one is due.
  void sign();
  /// Takes the test out again, and the file if this entry made it and nobody else uses it.
  void discard();
  void close();

 private:
  template <class Work>
  void in_transaction(const Work& work);
  void open();
  void connect();
  void bound();
  /// That have a row already, in order.
  std::vector<std::int64_t> readings_in(const std::string& table);
  std::vector<lab::Event> without_known(std::vector<lab::Event> events);
  void write(const TestStart& test, const Batch& batch, std::int64_t& id);

  std::string path_;
  std::chrono::milliseconds patience_;
  std::int64_t most_bytes_ = 0;
  bool continues_ = false, may_make_ = false;
  bool away_ = false;  ///< after abandon(), until the path has a database
  Lease lease_{Leased::test};
  std::optional<SQLite::Database> database_;
  std::optional<OpenFiles> files_;
  std::optional<ScanWriter> scans_;
  std::int64_t id_ = 0;
  std::optional<CreatedFile> created_;  ///< the database is new, and this entry made it
};

}  // namespace triax::db
