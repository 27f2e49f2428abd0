// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rows whose columns are listed once, for writing and for reading: a function template is given a
// visitor and a value,
//
//   template <class Row, class Point>
//   void visit(Row& row, Point& at) {
//     row("time_s", at.time_s);
//     row("q_kPa", at.q_pa, "kPa");
//   }
//
// Numbers are SI outside and in the column's unit inside, and come back to the bit: the table has a
// column last_bits, in which three bits for each number given by row() say how many units in the
// last place (−4 to 3) the stored one is off, and tell −0 from 0, which SQLite does not. A row
// without last_bits is as exact as its columns are.
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "db/columns.hpp"

namespace triax::db {

/// A column of whole numbers that tells rows apart.
struct Key {
  const char* name;
  std::int64_t value;
};

/// Collects the names of what is visited.
class ColumnNames {
 public:
  template <class T>
  void operator()(const char* name, const T& /*value*/, std::string_view /*unit*/ = {}) {
    names_.emplace_back(name);
  }
  template <class T>
  void follows(const char* name, const T& value, std::string_view unit = {}) {
    (*this)(name, value, unit);
  }
  void or_null(const char* name, const std::string& value) { (*this)(name, value); }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

/// Binds what is visited. What is not finite, or empty, becomes NULL.
class RowWriter {
 public:
  explicit RowWriter(SQLite::Statement& statement) : binder_(statement) {}

  void operator()(const char* name, const double& value, std::string_view unit = {});
  void operator()(const char* name, const std::optional<double>& value, std::string_view unit = {});
  void operator()(const char*, const std::int64_t& value) { binder_.integer(value); }
  void operator()(const char*, const std::optional<std::int64_t>& value) { binder_.integer(value); }
  void operator()(const char*, const int& value) { binder_.integer(value); }
  /// All 64 bits, as a signed number.
  void operator()(const char*, const std::uint64_t& value) {
    binder_.integer(static_cast<std::int64_t>(value));
  }
  void operator()(const char*, const bool& value) { binder_.integer(value ? 1 : 0); }
  void operator()(const char*, const std::string& value) { binder_.text(value); }
  /// A text whose emptiness is that it is unknown.
  void or_null(const char*, const std::string& value) { binder_.text_or_null(value); }
  /// What follows from other columns, for those who ask the database: not to the bit.
  void follows(const char*, const double& value, std::string_view unit = {}) {
    binder_.si(value, unit);
  }
  void follows(const char*, const std::optional<double>& value, std::string_view unit = {}) {
    binder_.si(value, unit);
  }
  void follows(const char*, const std::int64_t& value) { binder_.integer(value); }

  void key(std::int64_t value) { binder_.integer(value); }
  /// Binds last_bits and writes the row.
  void run() { binder_.integer(last_bits_).run(); }

 private:
  Binder binder_;
  std::int64_t last_bits_ = 0;
  int numbers_ = 0;
};

/// Fills what is visited from a row that begins with last_bits. NULL is NaN of a number, empty of
/// what may be empty, and leaves whole numbers as they were.
class RowReader {
 public:
  explicit RowReader(SQLite::Statement& statement);

  void operator()(const char* name, double& value, std::string_view unit = {});
  void operator()(const char* name, std::optional<double>& value, std::string_view unit = {});
  void operator()(const char* name, std::int64_t& value);
  void operator()(const char* name, std::optional<std::int64_t>& value);
  void operator()(const char* name, int& value);
  void operator()(const char* name, std::uint64_t& value);
  void operator()(const char* name, bool& value);
  void operator()(const char* name, std::string& value);
  void or_null(const char* name, std::string& value) { (*this)(name, value); }
  void follows(const char* name, double& value, std::string_view unit = {});
  void follows(const char* name, std::optional<double>& value, std::string_view unit = {});
  void follows(const char* name, std::int64_t& value) { (*this)(name, value); }

  /// Whether the row was written with its last bits: by a version that stores all of it.
  bool exact() const { return last_bits_.has_value(); }

 private:
  Columns columns_;
  std::optional<std::int64_t> last_bits_;
  int numbers_ = 0;
};

/// "INSERT INTO table (keys, names, last_bits) VALUES (?, ...)"
std::string insert_sql(const std::string& table, const std::vector<Key>& keys,
                       const std::vector<std::string>& names);
/// "SELECT last_bits, names FROM table WHERE key = ? AND ... ORDER BY order"
std::string select_sql(const std::string& table, const std::vector<Key>& keys,
                       const std::vector<std::string>& names, const std::string& order);

/// Writes the row of `keys` with what `visit(row)` visits.
template <class Visit>
void insert_row(SQLite::Database& database, const std::string& table, const std::vector<Key>& keys,
                const Visit& visit) {
  ColumnNames names;
  visit(names);
  SQLite::Statement insert(database, insert_sql(table, keys, names.names()));
  RowWriter row(insert);
  for (const Key& key : keys) row.key(key.value);
  visit(row);
  row.run();
}

/// A T for each row that has these keys, filled by `visit(row, T&)`.
template <class T, class Visit>
std::vector<T> select_rows(SQLite::Database& database, const std::string& table,
                           const std::vector<Key>& keys, const Visit& visit,
                           const std::string& order = {}) {
  ColumnNames names;
  T blank{};
  visit(names, blank);
  SQLite::Statement select(database, select_sql(table, keys, names.names(), order));
  for (std::size_t k = 0; k < keys.size(); ++k) select.bind(static_cast<int>(k) + 1, keys[k].value);
  std::vector<T> rows;
  while (select.executeStep()) {
    RowReader row(select);
    visit(row, rows.emplace_back());
  }
  return rows;
}

}  // namespace triax::db
