// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "lab/records/record_writer.hpp"
#include "lab/rig/back_end.hpp"

namespace triax::study {

/// The record that a command writes of a test beside the database. From what was stored: a disk
/// that takes no record ends no test.
class StoredRecord {
 public:
  /// Nothing is written where `path` is empty. Throws BadInput or WorkFailed where it cannot be
  /// written, before the test begins.
  StoredRecord(const std::string& path, const lab::RecordHeader& header);
  /// Once the test is stored. Empty, or why it was not written, a whole sentence.
  [[nodiscard]] std::string write(const lab::BackEnd& rig, const std::string& db, std::int64_t id);

 private:
  std::optional<lab::RecordWriter> writer_;
};

}  // namespace triax::study
