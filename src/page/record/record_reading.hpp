// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An uploaded record is replayed as `triax replay` does it.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "src/page/request/upload.hpp"

namespace triax::src {

struct RecordToRead {
  std::string db;                                         ///< database that gets the test
  std::string name;                                       ///< of the file in the browser
  std::vector<std::pair<std::string, std::string>> sets;  ///< as in lab::RecordOptions
  std::string writer;  ///< as in db::Recorder; empty: a random name
};

/// Replays the record into the database. Returns a JSON object: "recognised" (what the head of the
/// file states), "guessed", "missing" (keys that the reduction needs and the file does not state),
/// "test" (its id, null if it was not stored) and "error" (what is wrong with the record, or null).
/// Throws lab::WorkFailed if the database cannot take the test.
std::string read_record(const RecordToRead& record, const Upload& upload);

}  // namespace triax::src
