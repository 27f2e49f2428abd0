// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <SQLiteCpp/Database.h>

#include <cstdint>

struct sqlite3_stmt;

namespace triax::db {

/// A prepared statement for what runs a million times: columns by plain C calls, because a class
/// around each of them costs more than the call.
class PlainStatement {
 public:
  /// `database` has to outlive the statement. Throws SQLite::Exception.
  PlainStatement(const SQLite::Database& database, const char* sql);
  ~PlainStatement();
  PlainStatement(const PlainStatement&) = delete;
  PlainStatement& operator=(const PlainStatement&) = delete;

  void bind(int parameter, double value);  ///< what is not finite becomes NULL
  void bind(int parameter, std::int64_t value);
  void bind_null(int parameter);

  /// To the next row; false behind the last one. Throws SQLite::Exception.
  bool step();
  /// Runs a statement that gives no rows, so that it can be run again.
  void run();

  bool is_null(int column) const;
  double number(int column) const;  ///< NaN for NULL
  std::int64_t integer(int column) const;

 private:
  const SQLite::Database& database_;
  sqlite3_stmt* statement_ = nullptr;
};

}  // namespace triax::db
