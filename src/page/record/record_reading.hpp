// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An uploaded record is replayed as `triax replay` does it, or only looked at.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/page/request/upload.hpp"

namespace triax::src {

enum class RecordTask {
  replay,   ///< into the database
  propose,  ///< what its columns may be
  preview,  ///< its stress path, without storing anything
};
/// "replay", "propose" or "preview", and back; nothing for another name.
std::string_view name_of(RecordTask task);
std::optional<RecordTask> find_record_task(std::string_view name);

struct RecordToRead {
  std::string db;                                         ///< database that gets the test
  std::string name;                                       ///< of the file in the browser
  std::vector<std::pair<std::string, std::string>> sets;  ///< as in lab::RecordOptions
  std::string writer{};  ///< as in db::Recorder; empty: a random name
  RecordTask task = RecordTask::replay;
  std::string dialect{};  ///< text of one (TOML); empty: it is found
  std::string sheet{};    ///< of a workbook; empty: it is found
};

/// Carries out the task. Dialects that are remembered beside the database are used.
///
/// propose: a JSON object as study::proposal_json() with "worksheets" and "worksheet" (of a
/// workbook), "own" (true if the file is in the format of triax, which no choice improves) and
/// "error". preview: as study::preview_json() of the first test, or of the table side by side that
/// the dialect describes, with "tests" (their number), "shown" (from 1) and "error". replay:
/// replays all tests of the record into the database. Returns a JSON object: "recognised" (what the
/// head of the first test states), "guessed", "missing" (keys that the reduction needs and the file
/// does not state: then nothing is stored), "tests" (ids of those stored), "test" (the first id, or
/// null) and "error" (what is wrong with the record or with some tests, or null). Throws
/// lab::WorkFailed if the database cannot take the test.
std::string read_record(const RecordToRead& record, const Upload& upload);

}  // namespace triax::src
