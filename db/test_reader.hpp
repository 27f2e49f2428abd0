// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The rows of one test beside its scans, as values: the inverse of test_writer.
#include <SQLiteCpp/Database.h>

#include <cstdint>

#include "db/columns.hpp"
#include "db/store.hpp"

namespace triax::db {

/// From the columns last_sign_of_life and silent_s.
std::optional<SignOfLife> sign_of_life(Columns& columns);
/// Its id is 0 if there is no test of that id.
StoredTest read_test(SQLite::Database& database, std::int64_t id);

}  // namespace triax::db
