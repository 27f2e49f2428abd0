// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who writes a test or a run of grains: a lease in the database, which its writer renews for as
// long as it lives. Readers judge by the time of the last sign (migration 0013, seen_leases), who
// marks or removes by two looks at its heartbeats (db/recording/silent_writers.hpp); nobody asks
// for processes, which another PID namespace or host has under other numbers.
#include <SQLiteCpp/Database.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

namespace triax::db {

/// What a lease is about.
enum class Leased { test, grain_run };

/// Inside the caller's transactions; one thread at a time.
class Lease {
 public:
  /// A sign of life is due after this time. Readers wait ten times as long.
  static constexpr std::chrono::seconds kBeat{2};

  explicit Lease(Leased what);
  /// Of a writer that is gone.
  Lease(Leased what, std::string writer) : what_(what), writer_(std::move(writer)) {}
  /// Random, 128 bits in hexadecimal figures.
  const std::string& writer() const { return writer_; }
  /// Of the row `id`, which this writer has made or found without a living writer.
  void take(SQLite::Database& database, std::int64_t id) const;
  /// Of the row that this lease is about; 0 where there is none.
  std::int64_t row(SQLite::Database& database) const;
  /// Before anything else is written: a sign of life. Where somebody took this writer for dead and
  /// marked the row as interrupted, it runs again. Throws lab::WorkFailed where the row was
  /// removed.
  void renew(SQLite::Database& database);
  /// Whether kBeat has passed since the last renewal.
  bool is_due() const { return std::chrono::steady_clock::now() >= due_; }
  /// The row is complete.
  void end(SQLite::Database& database) const;

 private:
  Leased what_;
  std::string writer_;
  std::chrono::steady_clock::time_point due_{};
};

}  // namespace triax::db
