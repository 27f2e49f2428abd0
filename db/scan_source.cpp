// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/scan_source.hpp"

#include <SQLiteCpp/Exception.h>
#include <sqlite3.h>

#include <cmath>
#include <string>

#include "db/channel_columns.hpp"

namespace triax::db {
namespace {

struct Table : sqlite3_vtab {
  ScanSource* source = nullptr;
};

struct Cursor : sqlite3_vtab_cursor {
  std::size_t next = 0;
  std::int64_t id = 0;
  ScanRow row;
};

// Columns are those of scan_columns(), in that order: three, the raw channels, and these.
constexpr int kFirstChannel = 3;
constexpr int kBehindChannels = kFirstChannel + static_cast<int>(lab::kRawQuantityCount);
enum Behind { kAxialStrain, kVolumetricStrain, kQ, kPEff, kLastBits, kAddedLastBits };

int connect(sqlite3* database, void* source, int, const char* const*, sqlite3_vtab** made, char**) {
  auto* const table = new Table{};
  table->source = static_cast<ScanSource*>(source);
  *made = table;
  const std::string sql = "CREATE TABLE incoming_scans (" + column_list(scan_columns()) + ")";
  return sqlite3_declare_vtab(database, sql.c_str());
}

int disconnect(sqlite3_vtab* table) {
  delete static_cast<Table*>(table);
  return SQLITE_OK;
}

int best_index(sqlite3_vtab*, sqlite3_index_info*) { return SQLITE_OK; }

int open(sqlite3_vtab*, sqlite3_vtab_cursor** made) {
  *made = new Cursor{};
  return SQLITE_OK;
}

int close(sqlite3_vtab_cursor* cursor) {
  delete static_cast<Cursor*>(cursor);
  return SQLITE_OK;
}

ScanSource& source_of(sqlite3_vtab_cursor* cursor) {
  return *static_cast<Table*>(cursor->pVtab)->source;
}

int encode_current(Cursor& cursor) {
  ScanSource& source = source_of(&cursor);
  if (cursor.next >= source.scans.size()) return SQLITE_OK;
  try {
    cursor.id = source.encode(source.scans[cursor.next], cursor.row);
    return SQLITE_OK;
  } catch (...) {  // must not pass through SQLite's C code
    source.failure = std::current_exception();
    return SQLITE_ABORT;
  }
}

int filter(sqlite3_vtab_cursor* cursor, int, const char*, int, sqlite3_value**) {
  static_cast<Cursor*>(cursor)->next = 0;
  return encode_current(*static_cast<Cursor*>(cursor));
}

int next(sqlite3_vtab_cursor* cursor) {
  ++static_cast<Cursor*>(cursor)->next;
  return encode_current(*static_cast<Cursor*>(cursor));
}

int at_end(sqlite3_vtab_cursor* cursor) {
  return static_cast<Cursor*>(cursor)->next >= source_of(cursor).scans.size();
}

// A column without a result is NULL.
void result(sqlite3_context* context, double value) {
  if (std::isfinite(value)) sqlite3_result_double(context, value);
}

void result_unless_zero(sqlite3_context* context, std::int64_t bits) {
  if (bits != 0) sqlite3_result_int64(context, bits);
}

int column(sqlite3_vtab_cursor* cursor, sqlite3_context* context, int index) {
  const Cursor& at = *static_cast<Cursor*>(cursor);
  const ScanRow& row = at.row;
  if (index >= kFirstChannel && index < kBehindChannels) {
    result(context, row.raw[static_cast<std::size_t>(index - kFirstChannel)]);
    return SQLITE_OK;
  }
  switch (index) {
    case 0:
      sqlite3_result_int64(context, at.id);
      break;
    case 1:
      result(context, row.time_s);
      break;
    case 2:
      sqlite3_result_int(context, row.stage);
      break;
    case kBehindChannels + kAxialStrain:
      result(context, row.axial_strain);
      break;
    case kBehindChannels + kVolumetricStrain:
      result(context, row.volumetric_strain);
      break;
    case kBehindChannels + kQ:
      result(context, row.q_pa);
      break;
    case kBehindChannels + kPEff:
      result(context, row.p_eff_pa);
      break;
    case kBehindChannels + kLastBits:
      result_unless_zero(context, row.last_bits);
      break;
    default:
      result_unless_zero(context, row.added_last_bits);
  }
  return SQLITE_OK;
}

int rowid(sqlite3_vtab_cursor* cursor, sqlite3_int64* id) {
  *id = static_cast<Cursor*>(cursor)->id;
  return SQLITE_OK;
}

// Without xCreate the table exists on every connection it is registered with, and in no schema.
constexpr sqlite3_module kModule = [] {
  sqlite3_module module{};
  module.xConnect = connect;
  module.xDisconnect = disconnect;
  module.xBestIndex = best_index;
  module.xOpen = open;
  module.xClose = close;
  module.xFilter = filter;
  module.xNext = next;
  module.xEof = at_end;
  module.xColumn = column;
  module.xRowid = rowid;
  return module;
}();

}  // namespace

void register_scan_source(sqlite3* database, ScanSource& source) {
  if (sqlite3_create_module(database, "incoming_scans", &kModule, &source) != SQLITE_OK)
    throw SQLite::Exception(database);
}

}  // namespace triax::db
