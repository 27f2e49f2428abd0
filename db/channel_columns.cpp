// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/channel_columns.hpp"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "db/scans/scan_codec.hpp"
#include "lab/results/quantity.hpp"

namespace triax::db {
namespace {

using Names = std::vector<std::string>;

/// What holds for the columns of quantities: everything else is in the migrations.
std::string given(const lab::QuantityInfo& row) { return "given_" + lab::heading(row.quantity); }

Names make_scan_columns() {
  Names names = {"id", "time_s", "stage"};
  for (const lab::QuantityInfo& row : lab::raw_channels())
    names.push_back(lab::heading(row.quantity));
  for (const char* name : {"axial_strain", "volumetric_strain", "q_Pa", "p_eff_Pa", "last_bits"})
    names.emplace_back(name);
  if (kAddedChannelCount > 0) names.emplace_back("added_last_bits");
  return names;
}

Names make_detail_columns() {
  Names names = {"id"};
  for (const lab::QuantityInfo& row : lab::quantities().subspan(lab::kRawQuantityCount))
    names.push_back(given(row));
  names.emplace_back("given_last_bits");
  for (const char* name :  // in the order of Derived
       {"radial_strain", "void_ratio", "area_m2", "effective_axial_stress_Pa",
        "effective_radial_stress_Pa", "pore_pressure_Pa"})
    names.push_back(std::string("state_") + name);
  names.emplace_back("state_missing");
  return names;
}

Names columns_of(SQLite::Database& database, const std::string& table) {
  SQLite::Statement select(database, "SELECT name FROM pragma_table_info(?)");
  select.bind(1, table);
  Names names;
  while (select.executeStep()) names.push_back(select.getColumn(0).getString());
  return names;
}

/// Those of `wanted` that are not `there`.
Names without(const Names& wanted, const Names& there) {
  Names missing;
  std::ranges::copy_if(wanted, std::back_inserter(missing), [&](const std::string& name) {
    return std::ranges::find(there, name) == there.end();
  });
  return missing;
}

Names missing_in(SQLite::Database& database, const std::string& table, const Names& wanted) {
  return without(wanted, columns_of(database, table));
}

Names raw_headings() {
  Names names;
  for (const lab::QuantityInfo& row : lab::raw_channels())
    names.push_back(lab::heading(row.quantity));
  return names;
}

Names given_headings() {
  Names names;
  for (const lab::QuantityInfo& row : lab::quantities().subspan(lab::kRawQuantityCount))
    names.push_back(given(row));
  return names;
}

/// A column of SQLite's whole numbers is called so, all others hold reals.
void add_columns(SQLite::Database& database, const std::string& table, const Names& names) {
  for (const std::string& name : names)
    database.exec(fmt::format("ALTER TABLE {} ADD COLUMN {} {}", table, name,
                              name.ends_with("last_bits") ? "INTEGER" : "REAL"));
}

/// What instruments and files gave, in units of the field. Filters on test_id become ranges of
/// scans.id.
std::string select_readings(SQLite::Database& database) {
  return "SELECT t.id AS test_id, t.name AS test, t.origin, s.id & 4294967295 AS reading, "
         "s.time_s, s.stage, " +
         selected(database, "scans", "s", raw_headings()) + ", " +
         selected(database, "scan_details", "d", given_headings()) +
         " FROM tests t "
         "JOIN scans s ON s.id BETWEEN t.id << 32 AND t.id << 32 | 4294967295 "
         "LEFT JOIN scan_details d ON d.id = s.id";
}

std::string create_readings(SQLite::Database& database) {
  return "CREATE VIEW readings AS " + select_readings(database);
}

/// Word for word: a view of that name that another program made is none of ours.
bool has_own_view(SQLite::Database& database) {
  SQLite::Statement select(database,
                           "SELECT 1 FROM sqlite_schema WHERE type = 'view' AND name = 'readings' "
                           "AND sql = ?");
  select.bind(1, create_readings(database));
  return select.executeStep();
}

}  // namespace

const Names& scan_columns() {
  static const Names names = make_scan_columns();
  return names;
}

const Names& detail_columns() {
  static const Names names = make_detail_columns();
  return names;
}

std::string column_list(const Names& columns, const std::string& prefix) {
  std::string text;
  for (const std::string& name : columns)
    text += fmt::format("{}{}{}", text.empty() ? "" : ", ", prefix, name);
  return text;
}

std::string selected(SQLite::Database& database, const std::string& table, const std::string& alias,
                     const Names& columns) {
  const Names missing = missing_in(database, table, columns);
  std::string text;
  for (const std::string& name : columns) {
    const bool there = std::ranges::find(missing, name) == missing.end();
    if (!text.empty()) text += ", ";
    text += there ? fmt::format("{}.{}", alias, name) : fmt::format("NULL AS {}", name);
  }
  return text;
}

bool has_all_channels(SQLite::Database& database) {
  return missing_in(database, "scans", scan_columns()).empty() &&
         missing_in(database, "scan_details", detail_columns()).empty() && has_own_view(database);
}

void add_missing_channels(SQLite::Database& database) {
  add_columns(database, "scans", missing_in(database, "scans", scan_columns()));
  add_columns(database, "scan_details", missing_in(database, "scan_details", detail_columns()));
  if (!has_own_view(database))
    database.exec("DROP VIEW IF EXISTS readings; " + create_readings(database));
}

void show_all_channels(SQLite::Database& database) {
  database.exec("PRAGMA temp_store = MEMORY; CREATE TEMP VIEW readings AS " +
                select_readings(database));
}

}  // namespace triax::db
