// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "db/catalogue.hpp"
#include "db/recording/silent_writers.hpp"

namespace triax::db {

struct Repaired {
  std::vector<ListedTest> tests;  ///< marked as interrupted, as they are then
  std::vector<std::string> runs;  ///< of grains, likewise: "run 3 'dense'"
};

/// Takes in the readings that a writer that is gone left waiting beside the database
/// (db/recording/spool.hpp), marks what gives no sign of life as interrupted, and brings an older
/// schema up to date. A writer that was only held up (a sleeping computer, a lock of an hour) goes
/// on with its test when it comes back: nothing is lost by a repair too early. Makes a database
/// only where readings wait beside none; throws as open_for_writing() does.
Repaired repair(const std::string& path, const Looks& looks = {});

}  // namespace triax::db
