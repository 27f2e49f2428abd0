// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/missing_readings.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include "db/connection.hpp"

namespace triax::db {
namespace {

/// One test, or all for 0. Rows are counted one by one.
std::vector<MissingReadings> select_missing(SQLite::Database& database, std::int64_t test) {
  SQLite::Statement select(
      database,
      "SELECT id, name, stored, readings FROM (SELECT t.id, t.name, t.readings, "
      "(SELECT count(*) FROM scans s WHERE s.id BETWEEN t.id << 32 AND t.id << 32 | 4294967295) "
      "AS stored FROM tests t WHERE ?1 IN (0, t.id)) WHERE stored < readings");
  select.bind(1, test);
  std::vector<MissingReadings> found;
  while (select.executeStep())
    found.push_back({select.getColumn(0).getInt64(), select.getColumn(1).getString(),
                     select.getColumn(2).getInt64(), select.getColumn(3).getInt64()});
  return found;
}

/// SQLite counts a whole table by its pages, in a fiftieth of the time.
bool adds_up(SQLite::Database& database) {
  return database
             .execAndGet(
                 "SELECT (SELECT count(*) FROM scans) = (SELECT coalesce(sum(readings), 0) FROM "
                 "tests) AND NOT EXISTS (SELECT 1 FROM tests WHERE readings IS NULL)")
             .getInt() != 0;
}

/// True if the test has so large a part of all readings that adds_up() is quicker than its count.
bool is_large(SQLite::Database& database, std::int64_t test) {
  SQLite::Statement select(
      database,
      "SELECT 50 * readings >= (SELECT sum(readings) FROM tests) FROM tests WHERE id = ?");
  select.bind(1, test);
  return select.executeStep() && select.getColumn(0).getInt() != 0;
}

}  // namespace

std::string in_words(const MissingReadings& missing) {
  return fmt::format("{} of its {} readings are missing from the database",
                     missing.at_the_end - missing.stored, missing.at_the_end);
}

std::optional<MissingReadings> missing_readings(SQLite::Database& database, std::int64_t test) {
  if (is_large(database, test) && adds_up(database)) return std::nullopt;
  const auto found = select_missing(database, test);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

std::vector<MissingReadings> missing_readings(const std::string& path) {
  SQLite::Database database = open_for_reading(path);
  try {
    return adds_up(database) ? std::vector<MissingReadings>{} : select_missing(database, 0);
  } catch (const SQLite::Exception& error) {
    throw_for(error, path);
  }
}

}  // namespace triax::db
