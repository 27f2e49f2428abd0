// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The back end that replays a record file: our CSV, or a foreign one by its dialect.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lab/base/byte_source.hpp"
#include "lab/rig/back_end.hpp"

namespace triax::lab {

struct RecordOptions {
  std::string dialect;  ///< name of a shipped one or path of a .toml file; empty: recognise it
  std::string sheet;    ///< of a workbook; empty: the dialect's, else the first that is recognised
  /// KEY=VALUE of --set, stronger than what the file says ("specimen.height_mm", "140").
  std::vector<std::pair<std::string, std::string>> sets;
};

/// Streams a record in constant memory. Readings come with a strictly increasing test time and with
/// reset counters joined; whatever was changed or assumed stands in header().warnings, complete
/// once next() has returned false.
class RecordedRig : public BackEnd {
 public:
  /// `metadata` is the text of a TOML file beside the record, `metadata_file` its name; both empty
  /// if there is none. It counts only where the record has no metadata of its own.
  RecordedRig(std::unique_ptr<ByteSource> source, const RecordOptions& options,
              const std::string& metadata_file, const std::string& metadata);
  ~RecordedRig() override;

  const RecordHeader& header() const override;
  bool next(Reading& reading) override;
  double progress() const override;
  std::optional<Truth> truth() const override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Opens a record file, with x.toml beside x.csv. Throws BadInput for everything that can be seen
/// in the head of the file and the first row; the rest is thrown by next().
std::unique_ptr<RecordedRig> open_record(const std::string& path, const RecordOptions& options);
/// The same from bytes that are already there (tests, fuzzers).
std::unique_ptr<RecordedRig> open_record(std::unique_ptr<ByteSource> source,
                                         const RecordOptions& options);

}  // namespace triax::lab
