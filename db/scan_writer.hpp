#pragma once
#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <map>

#include "db/plain_statement.hpp"
#include "db/scan_codec.hpp"
#include "lab/collapse/second_order_work_point.hpp"

namespace triax::db {

/// Writes the scans of one test: the statement that runs a million times. Inside the caller's
/// transaction; after a failure the transaction has to be rolled back and the writer thrown away.
class ScanWriter {
 public:
  /// `database` has to outlive the writer.
  ScanWriter(SQLite::Database& database, std::int64_t test_id);

  /// Throws SQLite::Exception; lab::WorkFailed for a reading number that does not fit the key.
  void write(const lab::Reading& reading, const lab::State& state);
  void write(const lab::SecondOrderWorkPoint& point);

 private:
  std::int64_t key(std::int64_t reading) const;
  const StageReference& reference(const lab::State& state);
  void write_detail(std::int64_t id, const ScanDetail& detail);

  SQLite::Database& database_;
  std::int64_t test_id_;
  PlainStatement scan_, detail_, work_;
  std::map<int, StageReference> references_;
  int current_stage_ = 0;
  const StageReference* current_ = nullptr;
};

}  // namespace triax::db
