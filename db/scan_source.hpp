// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A batch of scans as a table that SQL can select from. `INSERT INTO scans (...) SELECT ... FROM
// incoming_scans` stores a batch in one statement: a quarter faster than one INSERT a scan.
#include <cstdint>
#include <exception>
#include <functional>
#include <span>

#include "db/scans/scan_codec.hpp"

struct sqlite3;

namespace triax::db {

struct Scan {
  Scan() = default;
  Scan(const lab::Reading& its_reading, const lab::State& its_state)
      : reading(its_reading), state(its_state) {}
  lab::Reading reading;
  lab::State state;
};

/// What `incoming_scans` gives while an INSERT runs.
struct ScanSource {
  std::span<const Scan> scans;
  /// Makes the row of a scan; returns its id. May throw: the statement then fails, `failure` is
  /// set.
  std::function<std::int64_t(const Scan&, ScanRow&)> encode;
  std::exception_ptr failure;
};

/// Makes the table known to a connection; `source` has to outlive that. Throws SQLite::Exception.
void register_scan_source(sqlite3* database, ScanSource& source);

}  // namespace triax::db
