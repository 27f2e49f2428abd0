// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/query.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "db/connection.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::db {
namespace {

/// True for a PRAGMA that reports and changes nothing.
bool is_harmless_pragma(const char* name, bool has_argument) {
  // An argument of these would be an assignment.
  static constexpr std::array kWithoutArgument{"application_id", "compile_options", "database_list",
                                               "function_list",  "page_count",      "page_size",
                                               "schema_version", "user_version"};
  // The argument is a table, an index or a number of errors.
  static constexpr std::array kWithArgument{
      "foreign_key_check", "foreign_key_list", "index_info", "index_list", "index_xinfo",
      "integrity_check",   "quick_check",      "table_info", "table_list", "table_xinfo"};
  const auto is_name = [&](const char* pragma) { return sqlite3_stricmp(pragma, name) == 0; };
  return std::ranges::any_of(kWithArgument, is_name) ||
         (!has_argument && std::ranges::any_of(kWithoutArgument, is_name));
}

/// For a PRAGMA, `first` is its name and `second` what stands behind it.
int authorize(void*, int action, const char* first, const char* second, const char*, const char*) {
  switch (action) {
    case SQLITE_SELECT:
    case SQLITE_READ:
    case SQLITE_FUNCTION:
    case SQLITE_RECURSIVE:
      return SQLITE_OK;
    case SQLITE_PRAGMA:
      return is_harmless_pragma(first, second != nullptr) ? SQLITE_OK : SQLITE_DENY;
    default:
      return SQLITE_DENY;
  }
}

std::vector<std::string> query_names() {
  std::vector<std::string> names;
  for (const NamedQuery& query : named_queries()) names.emplace_back(query.name);
  return names;
}

std::string sql_for(const std::string& name_or_sql) {
  for (const NamedQuery& query : named_queries())
    if (query.name == name_or_sql) return std::string(query.sql);
  if (name_or_sql.find_first_of(" \t\n\r;(") == std::string::npos)
    throw lab::BadInput("unknown query " + lab::excerpt(name_or_sql) + "; " +
                        lab::suggestion(name_or_sql, query_names()) + "; or give an SQL statement");
  return name_or_sql;
}

/// SQLite prepares the first statement only and says where it ended; more than blanks, semicolons
/// and comments behind that would be left out without a word.
void check_single(sqlite3* database, const std::string& sql) {
  sqlite3_stmt* statement = nullptr;
  const char* rest = sql.c_str();
  int statements = 0;
  while (*rest != '\0') {
    const int outcome = sqlite3_prepare_v2(database, rest, -1, &statement, &rest);
    statements += statement != nullptr || outcome != SQLITE_OK;
    sqlite3_finalize(statement);
    if (outcome != SQLITE_OK && statements == 1) throw SQLite::Exception(database);
    if (statements > 1) throw lab::BadInput("the SQL has more than one statement; give one");
  }
  if (statements == 0) throw lab::BadInput("the SQL has no statement; write a SELECT");
}

/// The database, not the question, is at fault: disk, lock, memory, damage.
bool is_failure_of_work(const SQLite::Exception& error) {
  switch (error.getErrorCode() & 0xff) {
    case SQLITE_ERROR:
    case SQLITE_AUTH:
    case SQLITE_READONLY:
    case SQLITE_NOTADB:
    case SQLITE_MISUSE:
    case SQLITE_RANGE:
    case SQLITE_MISMATCH:
    case SQLITE_TOOBIG:
    case SQLITE_CONSTRAINT:
      return false;
    default:
      return true;
  }
}

Value value_of(const SQLite::Column& column) {
  switch (column.getType()) {
    case SQLITE_INTEGER:
      return column.getInt64();
    case SQLITE_FLOAT:
      return column.getDouble();
    case SQLITE_NULL:
      return std::monostate{};
    default:
      return column.getString();
  }
}

/// Interrupts a statement that has computed for longer than its limit; what its rows are used for
/// does not count.
class TimeLimit {
 public:
  TimeLimit(SQLite::Database& database, double limit_s) : left_(limit_s) {
    constexpr int kSteps = 10000;  // of SQLite's machine: about a millisecond
    sqlite3_progress_handler(database.getHandle(), kSteps, is_over, this);
  }
  /// The next row; false behind the last one.
  bool step(SQLite::Statement& statement) {
    began_ = Clock::now();
    const bool more = statement.executeStep();
    left_ -= Clock::now() - began_;
    return more;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static int is_over(void* self) {
    const auto& limit = *static_cast<TimeLimit*>(self);
    return Clock::now() - limit.began_ > limit.left_ ? 1 : 0;
  }

  std::chrono::duration<double> left_;
  Clock::time_point began_ = Clock::now();
};

}  // namespace

void query(const std::string& path, const std::string& name_or_sql,
           const std::function<void(const std::vector<std::string>&)>& columns,
           const std::function<void(const std::vector<Value>&)>& row, double time_limit_s) {
  const std::string sql = sql_for(name_or_sql);
  SQLite::Database database = open_for_reading(path);
  sqlite3_set_authorizer(database.getHandle(), authorize, nullptr);
  TimeLimit limit(database, time_limit_s);
  try {
    check_single(database.getHandle(), sql);
    SQLite::Statement statement(database, sql);
    std::vector<std::string> names;
    names.reserve(static_cast<std::size_t>(statement.getColumnCount()));
    for (int i = 0; i < statement.getColumnCount(); ++i)
      names.emplace_back(statement.getColumnName(i));
    columns(names);
    std::vector<Value> values(names.size());
    while (limit.step(statement)) {
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = value_of(statement.getColumn(static_cast<int>(i)));
      row(values);
    }
  } catch (const SQLite::Exception& error) {
    if (error.getErrorCode() == SQLITE_INTERRUPT)
      throw lab::WorkFailed(fmt::format(
          "the query did not finish within {:g} s; simplify it or set a longer --time-limit S",
          time_limit_s));
    if (is_failure_of_work(error)) throw lab::WorkFailed(path + ": " + error.what());
    if ((error.getErrorCode() & 0xff) == SQLITE_AUTH ||
        (error.getErrorCode() & 0xff) == SQLITE_READONLY)
      throw lab::BadInput("SQL: this statement would change the database; queries are read-only");
    throw lab::BadInput("SQL: " + std::string(error.what()));
  }
}

}  // namespace triax::db
