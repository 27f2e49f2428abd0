// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The corrections of a stored test.
#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lab/results/summary.hpp"

namespace triax::db {

struct RevisedValue {
  std::string key;     ///< as in --set: "specimen.height_mm"
  std::string before;  ///< as text; empty: unknown
  std::string after;   ///< empty: as first stored
};

/// The changes, and the results of the test before them.
struct Revision {
  std::int64_t number = 2;  ///< the test as first stored is revision 1
  std::string revised_at;   ///< ISO 8601, UTC
  std::vector<RevisedValue> values;
  std::optional<lab::CollapseKind> former_kind;  ///< empty: not assessed
  std::optional<double> former_eta;              ///< at the onset; empty: there was none
};

/// Oldest first.
std::vector<Revision> read_revisions(SQLite::Database& database, std::int64_t test_id);
/// Inside the caller's transaction.
void insert_revision(SQLite::Database& database, std::int64_t test_id, const Revision& revision);

}  // namespace triax::db
