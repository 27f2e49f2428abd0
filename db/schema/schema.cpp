// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/schema/schema.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <charconv>
#include <map>
#include <mutex>
#include <span>
#include <tuple>
#include <utility>

#include "db/schema/schema_text.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/embedded.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {
extern const std::span<const EmbeddedFile> kMigrations, kSchema;
}

namespace triax::db {
namespace {

struct Part {
  std::string table;  ///< that it is, or belongs to
  std::string sql;    ///< empty of an index that SQLite makes itself
};
/// By type ("table", "index", "view", "trigger") and name.
using Parts = std::map<std::pair<std::string, std::string>, Part>;

/// Made by the program from its table of quantities, whatever the file has there.
const Parts::key_type kReadings = {"view", "readings"};

int version_of(const lab::EmbeddedFile& migration) {
  int version = 0;
  std::from_chars(migration.name.data(), migration.name.data() + migration.name.size(), version);
  return version;
}

Parts parts_of(SQLite::Database& database) {
  SQLite::Statement all(database, "SELECT type, name, tbl_name, sql FROM sqlite_schema");
  Parts parts;
  while (all.executeStep())
    parts[{all.getColumn(0).getString(), all.getColumn(1).getString()}] = {
        all.getColumn(2).getString(), all.getColumn(3).getString()};
  return parts;
}

const Parts& expected_parts(int version) {
  static std::mutex mutex;
  static std::map<int, Parts> made;
  const std::lock_guard lock(mutex);
  const auto [place, is_new] = made.try_emplace(version);
  if (is_new) {
    SQLite::Database model(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    apply_migrations(model, 0, version);
    place->second = parts_of(model);
    place->second.erase(kReadings);
  }
  return place->second;
}

[[noreturn]] void refuse(const std::string& path, const Parts::key_type& part,
                         const std::string& what) {
  throw lab::BadInput(
      path, 0,
      fmt::format("the {} {} of this database {}", part.first, lab::excerpt(part.second), what));
}

[[noreturn]] void refuse_foreign(const std::string& path, const Parts::key_type& part) {
  std::string upper = part.first;
  for (char& c : upper) c = static_cast<char>(c - 'a' + 'A');
  refuse(path, part,
         fmt::format("does not belong to triax and could change data; if you trust the rest of the "
                     "file, remove it with the sqlite3 shell (DROP {} {})",
                     upper, lab::excerpt(part.second)));
}

bool is_harmless(const Parts::key_type& key, const Part& part, const Parts& expected) {
  if (key.first == "table")
    return is_ordinary_table(part.sql) &&
           sqlite3_stricmp(key.second.c_str(), kReadings.second.c_str()) != 0;
  if (key.first != "index") return false;
  return part.sql.empty() || !expected.contains({"table", part.table}) || is_plain_index(part.sql);
}

/// A read transaction of its own, where the caller has none: version and schema of one instant.
class OneInstant {
 public:
  explicit OneInstant(SQLite::Database& database)
      : database_(database), is_own_(sqlite3_get_autocommit(database.getHandle()) != 0) {
    if (is_own_) database_.exec("BEGIN");
  }
  ~OneInstant() {
    if (is_own_) database_.tryExec("COMMIT");
  }
  OneInstant(const OneInstant&) = delete;
  OneInstant& operator=(const OneInstant&) = delete;

 private:
  SQLite::Database& database_;
  bool is_own_;
};

}  // namespace

int newest_schema() { return version_of(lab::kMigrations.back()); }

void apply_migrations(SQLite::Database& database, int present, int target) {
  if (present == 0 && target >= newest_schema()) {  // a tenth of the time of all steps
    database.exec(std::string(lab::kSchema.front().text));
    return;
  }
  for (const lab::EmbeddedFile& migration : lab::kMigrations) {
    const int version = version_of(migration);
    if (version > present && version <= target) database.exec(std::string(migration.text));
  }
}

void distrust_schema(SQLite::Database& database) {
  for (const auto& [option, value] : {std::pair(SQLITE_DBCONFIG_DEFENSIVE, 1),
                                      {SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
                                      {SQLITE_DBCONFIG_ENABLE_TRIGGER, 0}})
    sqlite3_db_config(database.getHandle(), option, value, nullptr);
  database.exec("PRAGMA cell_size_check = ON");
}

void check_schema(SQLite::Database& database, const std::string& path) {
  const OneInstant instant(database);
  const int version = database.execAndGet("PRAGMA user_version").getInt();
  const Parts present = parts_of(database);
  if (present.empty()) return;
  const Parts& expected = expected_parts(version);
  for (const auto& [key, part] : expected) {
    const auto found = present.find(key);
    const std::string of = fmt::format("schema version {}", version);
    if (found == present.end())
      throw lab::BadInput(
          path, 0,
          fmt::format("the {} {} of {} is missing from the database; restore it from a backup",
                      key.first, lab::excerpt(key.second), of));
    if (found->second.sql != part.sql && !is_same_definition(found->second.sql, part.sql))
      refuse(path, key,
             "differs from that of " + of +
                 "; another program changed it: restore the file from a backup");
  }
  for (const auto& [key, part] : present)
    if (key != kReadings && !expected.contains(key) && !is_harmless(key, part, expected))
      refuse_foreign(path, key);
}

void check_pages(SQLite::Database& database, const std::string& path) {
  const std::string found = database.execAndGet("PRAGMA quick_check(1)").getString();
  if (found != "ok")
    throw lab::WorkFailed(
        fmt::format("{}: database is damaged and was not changed: {}; restore it from a backup, or "
                    "export the tests that can still be read",
                    path, lab::excerpt(found)));
}

}  // namespace triax::db
