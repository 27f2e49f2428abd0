// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/exact_row.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "db/scans/last_bits.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::db {
namespace {

constexpr int kBits = 3;
/// Beyond the last field of 64 bits a number is as exact as its column.
constexpr int kMostNumbers = 21;

BitField bits_of(int number) { return {kBits * number, kBits}; }

std::optional<double> decoded(std::optional<double> stored, std::string_view unit,
                              std::int64_t last_bits, int number) {
  if (!stored) return stored;
  const double si = sim::to_si(*stored, *sim::find_unit(unit));
  return number < kMostNumbers ? moved_by_ulps(si, bits_of(number).get(last_bits)) : si;
}

}  // namespace

void RowWriter::operator()(const char* /*name*/, const double& value, std::string_view unit) {
  const int number = numbers_++;
  if (!std::isfinite(value)) {
    binder_.number(std::nullopt);
    return;
  }
  const sim::Unit scale = *sim::find_unit(unit);
  const double stored = sim::to_field(value, scale) + 0.0;  // no −0
  binder_.number(stored);
  const std::int64_t ulps = ulps_between(sim::to_si(stored, scale), value);
  const BitField bits = bits_of(number);
  if (number < kMostNumbers && bits.holds(ulps)) last_bits_ |= bits.packed(ulps);
}

void RowWriter::operator()(const char* name, const std::optional<double>& value,
                           std::string_view unit) {
  (*this)(name, value.value_or(std::numeric_limits<double>::quiet_NaN()), unit);
}

RowReader::RowReader(SQLite::Statement& statement)
    : columns_(statement), last_bits_(columns_.integer()) {}

void RowReader::operator()(const char* /*name*/, std::optional<double>& value,
                           std::string_view unit) {
  value = decoded(columns_.number(), unit, last_bits_.value_or(0), numbers_++);
}
void RowReader::operator()(const char* name, double& value, std::string_view unit) {
  std::optional<double> read;
  (*this)(name, read, unit);
  value = read.value_or(std::numeric_limits<double>::quiet_NaN());
}
void RowReader::operator()(const char* /*name*/, std::optional<std::int64_t>& value) {
  value = columns_.integer();
}
void RowReader::operator()(const char* /*name*/, std::int64_t& value) {
  value = columns_.integer().value_or(value);
}
void RowReader::operator()(const char* /*name*/, int& value) {
  value = static_cast<int>(columns_.integer().value_or(value));
}
void RowReader::operator()(const char* /*name*/, std::uint64_t& value) {
  value = static_cast<std::uint64_t>(columns_.integer().value_or(static_cast<std::int64_t>(value)));
}
void RowReader::operator()(const char* /*name*/, bool& value) {
  value = columns_.truth().value_or(value);
}
void RowReader::operator()(const char* /*name*/, std::string& value) { value = columns_.text(); }
void RowReader::follows(const char* /*name*/, std::optional<double>& value, std::string_view unit) {
  value = columns_.si(unit);
}
void RowReader::follows(const char* /*name*/, double& value, std::string_view unit) {
  value = columns_.si(unit).value_or(std::numeric_limits<double>::quiet_NaN());
}

std::string insert_sql(const std::string& table, const std::vector<Key>& keys,
                       const std::vector<std::string>& names) {
  std::string columns, places;
  for (const Key& key : keys) columns += fmt::format("{}, ", key.name);
  for (const std::string& name : names) columns += name + ", ";
  for (std::size_t k = 0; k < keys.size() + names.size(); ++k) places += "?, ";
  return fmt::format("INSERT INTO {} ({}last_bits) VALUES ({}?)", table, columns, places);
}

std::string select_sql(const std::string& table, const std::vector<Key>& keys,
                       const std::vector<std::string>& names, const std::string& order) {
  std::string sql = "SELECT last_bits";
  for (const std::string& name : names) sql += ", " + name;
  sql += " FROM " + table;
  for (std::size_t k = 0; k < keys.size(); ++k)
    sql += fmt::format(" {} {} = ?", k == 0 ? "WHERE" : "AND", keys[k].name);
  return order.empty() ? sql : sql + " ORDER BY " + order;
}

}  // namespace triax::db
