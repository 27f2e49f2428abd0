// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Between optional SI values and the columns of a table: a value that is unknown is NULL, units of
// the field are left and entered here.
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace triax::db {

/// Binds one value after the other.
class Binder {
 public:
  explicit Binder(SQLite::Statement& statement) : statement_(statement) { statement_.reset(); }

  Binder& integer(std::optional<std::int64_t> value);
  /// In the unit of the column; what is not finite becomes NULL.
  Binder& number(std::optional<double> value);
  /// An SI value into a column in `unit`.
  Binder& si(std::optional<double> value, std::string_view unit);
  Binder& text(std::string_view value);
  /// An empty text is unknown.
  Binder& text_or_null(std::string_view value);
  /// A text that is a whole or real number as that number, any other as text.
  Binder& number_or_text(const std::string& value);
  void run() { statement_.exec(); }

 private:
  SQLite::Statement& statement_;
  int next_ = 1;
};

/// Reads one column after the other from the statement's current row.
class Columns {
 public:
  explicit Columns(SQLite::Statement& statement) : statement_(statement) {}

  std::optional<std::int64_t> integer();
  std::optional<bool> truth();
  std::optional<double> number();
  std::optional<double> si(std::string_view unit);
  std::string text();  ///< empty for NULL

 private:
  SQLite::Statement& statement_;
  int next_ = 0;
};

}  // namespace triax::db
