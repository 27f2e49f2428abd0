// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rows of what a test came to. All run inside the caller's transaction.
#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <vector>

#include "lab/results/summary.hpp"

namespace triax::db {

void insert_forecasts(SQLite::Database& database, std::int64_t test_id,
                      const std::vector<lab::Forecast>& forecasts);
/// All that a summary holds, and `complete`.
void insert_summary(SQLite::Database& database, std::int64_t test_id,
                    const lab::TestSummary& summary);

}  // namespace triax::db
