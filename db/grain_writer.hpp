// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rows of one run of grains. All run inside the caller's transaction.
#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <string>

#include "lab/grains/grain_run.hpp"

namespace triax::db {

/// The run is running. Returns its id.
std::int64_t insert_grain_run(SQLite::Database& database, const lab::GrainProgramme& programme,
                              const lab::GrainsMade& made, const std::string& recorded_at);
/// A stage with its points or probes.
void insert_grain_stage(SQLite::Database& database, std::int64_t run, std::int64_t number,
                        const lab::GrainStageResult& result);

}  // namespace triax::db
