// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Readings that a test had when it ended and that its database no longer has.
#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace triax::db {

struct MissingReadings {
  std::int64_t test = 0;
  std::string name;             ///< of the test
  std::int64_t stored = 0;      ///< that are there
  std::int64_t at_the_end = 0;  ///< that the test had when it ended
};
/// "1093 of its 3280 readings are missing from the database".
std::string in_words(const MissingReadings& missing);

/// Of one test; empty where none is missing, or where the test has not ended.
std::optional<MissingReadings> missing_readings(SQLite::Database& database, std::int64_t test);

/// Of all tests of the database; opens it as Store does.
std::vector<MissingReadings> missing_readings(const std::string& path);

}  // namespace triax::db
