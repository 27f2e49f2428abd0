// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a test came to, as its summary: the inverse of summary_writer.
#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <vector>

#include "lab/results/summary.hpp"

namespace triax::db {

/// All but its readings, its warnings and the membrane correction, which stand with the test.
void read_summary(SQLite::Database& database, std::int64_t id, lab::TestSummary& summary);
/// In the order in which they were said; apart from the rest, for there may be many.
std::vector<lab::Forecast> read_forecasts(SQLite::Database& database, std::int64_t id);

}  // namespace triax::db
