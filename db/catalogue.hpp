// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The tests of a database as a list, and what a user may change about them afterwards.
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "db/store.hpp"

namespace triax::db {

/// One test in a line.
struct ListedTest {
  std::int64_t id = 0;
  std::string name;
  lab::Origin origin = lab::Origin::recorded;
  std::string programme;
  TestStatus status = TestStatus::running;
  std::optional<SignOfLife> sign_of_life;  ///< as in StoredTest
  std::optional<lab::CollapseKind> kind;   ///< empty: there is no verdict
  std::int64_t readings = 0;               ///< so far, while it runs
  std::string stored_at;                   ///< ISO 8601, UTC
  std::string source, digest;              ///< as in lab::RecordHeader
  bool counted = true;                     ///< in statistics: no later reading of its file stands
  std::int64_t revision = 1;               ///< one more with each correction
  std::vector<std::string> tags;
};

/// Oldest first; with `tag` those that have it. Opens the database as Store does.
std::vector<ListedTest> list_tests(const std::string& path, const std::string& tag = {});

// The functions that follow do all that they were asked for, or throw lab::BadInput and change
// nothing: where there is no such test, or for a name or tag that is empty, not UTF-8 or of several
// lines. They open a database that is there and make none.

/// Gives the name that the test had.
std::string rename_test(const std::string& path, std::int64_t id, const std::string& name);
/// A tag that the test has already stays as it is.
void tag_test(const std::string& path, std::int64_t id, const std::vector<std::string>& tags);
/// Throws also for a tag that the test does not have.
void untag_test(const std::string& path, std::int64_t id, const std::vector<std::string>& tags);
/// All that is stored of them; gives what they were, oldest first. Throws also where one of them is
/// still being recorded: it runs, and its writer is none of the `silent`
/// (db/recording/silent_writers.hpp). The file does not shrink: the next test fills its room.
std::vector<ListedTest> remove_tests(const std::string& path, const std::vector<std::int64_t>& ids,
                                     const std::set<std::string>& silent = {});

}  // namespace triax::db
