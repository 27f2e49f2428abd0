// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rows of one test beside its scans. All run inside the caller's transaction.
#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <string>

#include "db/store.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/summary.hpp"

namespace triax::db {

/// Test, specimen, stages and warnings; the test is running. A file
/// that was read before (RecordHeader::digest) is one warning more. Returns the id of the test.
std::int64_t insert_test(SQLite::Database& database, const lab::RecordHeader& header,
                         const std::string& stored_at);
/// The parts that a correction can change: name, programme, specimen, stages, notes, assumptions.
void replace_header(SQLite::Database& database, std::int64_t test_id,
                    const lab::RecordHeader& header);
void insert_sweep(SQLite::Database& database, std::int64_t test_id, const SweepMembership& sweep);
void insert_event(SQLite::Database& database, std::int64_t test_id, const lab::Event& event);
void mark_interrupted(SQLite::Database& database, std::int64_t test_id);
/// Readings with their states, second-order work and forecasts.
void remove_scans(SQLite::Database& database, std::int64_t test_id);
/// Everything of that test, scans included.
void remove_test(SQLite::Database& database, std::int64_t test_id);

}  // namespace triax::db
