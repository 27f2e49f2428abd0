// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "db/recording/test_entry.hpp"

namespace triax::db {

/// Where the readings of one test wait while its database takes none: a database of its own beside
/// it, so that a kill loses nothing either, and every command can read what waits. It is called
/// DATABASE.waiting-WRITER, after the lease of the test. One thread at a time.
class Spool {
 public:
  /// Nothing is made before the first batch.
  Spool(const TestEntry& of, std::int64_t most_bytes);

  /// Whether nothing waits.
  bool is_empty() const { return entry_.id() == 0; }
  const std::string& path() const { return entry_.path(); }
  /// Throws MayPass where the disk or its bound is full: the batch then is still the caller's.
  void store(const TestStart& test, const Batch& batch) { entry_.store(test, batch); }
  /// A sign of life where one is due.
  void sign() { entry_.sign(); }
  /// All that the test has in a database that has moved, before what waits already.
  void rescue(TestEntry& test, const TestStart& start) { test.copy_into(entry_, start); }
  /// All that waits into the test itself. After a failure (MayPass) it may be called again: what
  /// went over is not taken twice.
  void empty_into(TestEntry& test, const TestStart& start);
  /// Takes the file away.
  void remove();

 private:
  TestEntry entry_;
};

/// The spools beside the database `path`, of any writer; `path` may be a symbolic link.
std::vector<std::string> spools_beside(const std::string& path);
/// The number of the test that waits in a spool; 0 where its writer was killed before the first
/// batch was in it, even before there were tables, or sets about it.
std::int64_t waiting_test(const std::string& spool);
/// What a writer that is gone left waiting goes into its test, or a new one, which is interrupted
/// then; the file goes. Gives the number of the test; none where the writer lives: has a lease and
/// is none of the `silent` (db/recording/silent_writers.hpp).
std::optional<std::int64_t> take_in(const std::string& spool, const std::string& database,
                                    const std::set<std::string>& silent);

/// Removes what the killed recorder of `writer` left of a test that it did not complete: its row
/// with all readings, and its spool. Also removes a database that holds nothing and that nobody
/// uses, if `was_there` says that it did not exist before this recorder. Pre-condition: the writer
/// is gone. Throws as open_for_writing() does.
void discard_left_test(const std::string& database, const std::string& writer, bool was_there);

/// What a writer that is gone left beside a database.
struct LeftWaiting {
  std::string spool;
  std::string test;           ///< its name; empty where the spool cannot be read
  std::int64_t readings = 0;  ///< that wait
};
/// For readers, who see nothing of it in the database; take_in() of each is what repair() does.
std::vector<LeftWaiting> left_waiting(const std::string& database);

}  // namespace triax::db
