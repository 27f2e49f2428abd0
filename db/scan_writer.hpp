// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "db/plain_statement.hpp"
#include "db/scan_source.hpp"
#include "lab/results/second_order_work_point.hpp"

namespace triax::db {

/// Void ratio and area at zero strain of each stage of a test that has scans.
std::map<int, StageReference> stage_references(SQLite::Database& database, std::int64_t test_id);

/// Writes the scans of one test, of which some may be there: what runs a million times. Inside the
/// caller's transaction; after a failure the transaction has to be rolled back and the writer
/// thrown away.
class ScanWriter {
 public:
  /// `database` has to outlive the writer.
  ScanWriter(SQLite::Database& database, std::int64_t test_id);

  /// Both throw SQLite::Exception; lab::WorkFailed for a reading number that does not fit the key.
  void write(std::span<const Scan> scans);
  void write(const lab::SecondOrderWorkPoint& point);

 private:
  std::int64_t key(std::int64_t reading) const;
  std::int64_t encode_row(const Scan& scan, ScanRow& row);
  const StageReference& reference(const lab::State& state);
  void write_details();
  void write_references();

  SQLite::Database& database_;
  std::int64_t test_id_;
  ScanSource source_;
  PlainStatement scans_, detail_, work_;
  std::map<int, StageReference> references_;
  int current_stage_ = 0;
  const StageReference* current_ = nullptr;
  // Found while a batch runs, written behind it.
  ScanDetail found_;
  std::vector<std::pair<std::int64_t, ScanDetail>> details_;
  std::vector<int> new_stages_;
};

}  // namespace triax::db
