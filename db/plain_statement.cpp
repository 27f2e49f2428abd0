// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/plain_statement.hpp"

#include <sqlite3.h>

#include <cmath>
#include <limits>

namespace triax::db {

PlainStatement::PlainStatement(const SQLite::Database& database, const char* sql)
    : database_(database) {
  if (sqlite3_prepare_v3(database.getHandle(), sql, -1, SQLITE_PREPARE_PERSISTENT, &statement_,
                         nullptr) != SQLITE_OK)
    throw SQLite::Exception(database.getHandle());
}

PlainStatement::~PlainStatement() { sqlite3_finalize(statement_); }

void PlainStatement::bind(int parameter, double value) {
  if (std::isfinite(value))
    sqlite3_bind_double(statement_, parameter, value);
  else
    sqlite3_bind_null(statement_, parameter);
}

void PlainStatement::bind(int parameter, std::int64_t value) {
  sqlite3_bind_int64(statement_, parameter, value);
}

void PlainStatement::bind_null(int parameter) { sqlite3_bind_null(statement_, parameter); }

bool PlainStatement::step() {
  const int outcome = sqlite3_step(statement_);
  if (outcome == SQLITE_ROW) return true;
  if (outcome == SQLITE_DONE) return false;
  const SQLite::Exception error(database_.getHandle(), outcome);
  sqlite3_reset(statement_);
  throw error;
}

void PlainStatement::run() {
  step();
  sqlite3_reset(statement_);
}

bool PlainStatement::is_null(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}

double PlainStatement::number(int column) const {
  const double value = sqlite3_column_double(statement_, column);
  // NULL reads as zero: few values need the second call.
  return value == 0 && is_null(column) ? std::numeric_limits<double>::quiet_NaN() : value;
}

std::int64_t PlainStatement::integer(int column) const {
  return sqlite3_column_int64(statement_, column);
}

}  // namespace triax::db
