// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The rows of one run of grains as values: the inverse of grain_writer.
#include <SQLiteCpp/Database.h>

#include <cstdint>

#include "db/grain_store.hpp"

namespace triax::db {

/// To the bit what the writer was given. Throws lab::BadInput if there is no run of that id.
StoredGrainRun read_grain_run(SQLite::Database& database, std::int64_t id);

}  // namespace triax::db
