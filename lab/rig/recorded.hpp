// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The back end that replays a record file: our CSV, or a foreign one by its dialect.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/base/byte_source.hpp"
#include "lab/records/stated/set_value.hpp"
#include "lab/records/tables/table_tests.hpp"
#include "lab/rig/back_end.hpp"

namespace triax::lab {

struct DiggsDocument;
struct SheetRoles;
struct TableSample;
struct TestsInFile;

struct RecordOptions {
  std::string dialect;       ///< name of a shipped one or path of a .toml file; empty: recognise it
  std::string dialect_text;  ///< the TOML of a dialect, in place of `dialect`
  std::string dialect_folder;  ///< of a lab::DialectMemory, used without a dialect; empty: none
  std::optional<std::string> encoding;  ///< of a text; empty: the dialect's, else it is found
  /// Of a workbook; empty: the one of the dialect, else the first that is recognised, else the
  /// largest table.
  std::string sheet;
  /// Values of a job file (lab/records/job_file.hpp), stronger than the file.
  std::vector<SetValue> job{};
  /// KEY=VALUE of --set, stronger than both ("specimen.height_mm", "140").
  std::vector<std::pair<std::string, std::string>> sets{};
  std::size_t test = 0;  ///< of a file with several (tests_in()), from 1; 0: the only one
  std::shared_ptr<const TestsInFile> tests{};  ///< of tests_in(); empty: the file is searched
  bool names_dialect() const { return !dialect.empty() || !dialect_text.empty(); }
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

struct TestsInFile {
  std::vector<std::string> names;
  std::shared_ptr<const DiggsDocument> document;  ///< of a DIGGS file
  std::vector<TableTest> tables;                  ///< of any other file
  std::shared_ptr<const TableSample> sample{};    ///< of any other file with one table
  std::shared_ptr<const SheetRoles> sheets{};     ///< of a workbook
};
/// The tests of a DIGGS file, of worksheets with the same headings ("worksheet 'CU1'"), or of a
/// table with several ("cells 1 to 3, 'Specimen 1'", "lines 6 to 41"); no names for a table with
/// one, and for a file that open_record() cannot read. `options` gives dialect, encoding and
/// worksheet. Throws BadInput if a DIGGS file cannot be read or holds no triaxial test, and
/// SeveralTests for more tests than a file can have.
TestsInFile tests_in(const std::string& path, const RecordOptions& options = {},
                     Extent extent = Extent::sample);
/// The same of a file that is not on the disk; `open` opens it from its first byte.
TestsInFile tests_in(const std::function<std::unique_ptr<ByteSource>()>& open,
                     const RecordOptions& options, Extent extent = Extent::sample);

/// Opens a record file, with x.toml beside x.csv. Throws BadInput for everything that can be seen
/// in the head of the file and the first row; the rest is thrown by next().
std::unique_ptr<RecordedRig> open_record(const std::string& path, const RecordOptions& given);
/// The same from bytes that are already there (tests, fuzzers).
std::unique_ptr<RecordedRig> open_record(std::unique_ptr<ByteSource> source,
                                         const RecordOptions& options);

}  // namespace triax::lab
