// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A test as it was first stored, to the bit, so that it can be reduced and assessed again from its
// stored readings (db/corrections/correction.hpp). All run inside the caller's transaction.
#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <optional>

#include "lab/results/record_header.hpp"
#include "lab/results/summary.hpp"
#include "lab/warning/earlier_tests.hpp"

namespace triax::db {

struct FirstHeader {
  /// Programme, specimen, stages, notes, assumptions, vouched sensors and cut_short; the rest is
  /// empty. A name is not part of it: renaming is no correction.
  lab::RecordHeader header;
  lab::EarlierTests earlier;
  std::optional<lab::RecordEnding> ending;  ///< empty: the test has no result
};

void insert_first_header(SQLite::Database& database, std::int64_t test_id,
                         const lab::RecordHeader& header, const lab::EarlierTests& earlier);
/// Once a test: a later ending is ignored.
void set_first_ending(SQLite::Database& database, std::int64_t test_id,
                      const lab::RecordEnding& ending);
/// Empty for a test that an older triax stored. Throws lab::WorkFailed where the text is damaged.
std::optional<FirstHeader> read_first_header(SQLite::Database& database, std::int64_t test_id);

}  // namespace triax::db
