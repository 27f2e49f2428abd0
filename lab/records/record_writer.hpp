// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "lab/results/reading.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// Writes a record in triax's own CSV (docs/reference/record-files.md): the metadata as TOML behind
/// #, one row a reading, below the rows how it ended and the truth of a simulation.
///
/// The file appears under its name only when it is complete (WholeFile). Values are written in
/// units of the field with the fewest digits that give the reading's bits back: exactly for values
/// that came from such a file or instrument (sim::to_si), within one unit in the last place for
/// others.
class RecordWriter {
 public:
  /// Columns are header.columns, with time_s in front where header.has_time. Throws BadInput where
  /// `path` is no regular file, WorkFailed where the folder does not let itself be written.
  RecordWriter(const std::string& path, const RecordHeader& header);
  ~RecordWriter();
  RecordWriter(const RecordWriter&) = delete;
  RecordWriter& operator=(const RecordWriter&) = delete;

  /// A missing value becomes an empty cell. Throws WorkFailed (disk full).
  void write(const Reading& reading);
  /// Completes the file and gives it its name, replacing an older one. Throws WorkFailed, also
  /// where no reading was written: a record without any cannot be read. Then
  /// nothing stands under that name that was not there before.
  void finish(const RecordHeader& header, const std::optional<Truth>& truth);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace triax::lab
