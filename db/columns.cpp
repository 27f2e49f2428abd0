// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/columns.hpp"

#include <SQLiteCpp/Column.h>

#include <cmath>

#include "lab/base/text.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::db {

Binder& Binder::integer(std::optional<std::int64_t> value) {
  if (value)
    statement_.bind(next_++, *value);
  else
    statement_.bind(next_++);
  return *this;
}

Binder& Binder::number(std::optional<double> value) {
  if (value && std::isfinite(*value))
    statement_.bind(next_++, *value);
  else
    statement_.bind(next_++);
  return *this;
}

Binder& Binder::si(std::optional<double> value, std::string_view unit) {
  return number(value ? std::optional(sim::to_field(*value, *sim::find_unit(unit))) : value);
}

Binder& Binder::text(std::string_view value) {
  statement_.bind(next_++, std::string(value));
  return *this;
}

Binder& Binder::text_or_null(std::string_view value) {
  if (!value.empty()) return text(value);
  statement_.bind(next_++);
  return *this;
}

Binder& Binder::number_or_text(const std::string& value) {
  if (const auto whole = lab::whole_text_as<std::int64_t>(value)) return integer(whole);
  const auto real = lab::whole_text_as<double>(value);
  return real && std::isfinite(*real) ? number(real) : text(value);
}

std::optional<std::int64_t> Columns::integer() {
  const SQLite::Column column = statement_.getColumn(next_++);
  return column.isNull() ? std::nullopt : std::optional(column.getInt64());
}

std::optional<bool> Columns::truth() {
  const auto value = integer();
  return value ? std::optional(*value != 0) : std::nullopt;
}

std::optional<double> Columns::number() {
  const SQLite::Column column = statement_.getColumn(next_++);
  return column.isNull() ? std::nullopt : std::optional(column.getDouble());
}

std::optional<double> Columns::si(std::string_view unit) {
  const auto value = number();
  return value ? std::optional(sim::to_si(*value, *sim::find_unit(unit))) : value;
}

std::string Columns::text() { return statement_.getColumn(next_++).getString(); }

}  // namespace triax::db
