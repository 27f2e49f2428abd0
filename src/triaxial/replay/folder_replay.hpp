// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// `triax replay FOLDER`: the files of a folder, one after the other, each with its outcome.
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "db/store.hpp"
#include "src/reference/reference_files.hpp"
#include "src/triaxial/replay/record_replay.hpp"

namespace triax::src {

/// The result for one file.
struct FileOutcome {
  enum class Kind {
    stored,       ///< as test `test`, or as those up to `last_test`
    references,   ///< results of an AGS4 file
    read_before,  ///< the same bytes are stored as test `test`
    no_record,    ///< it holds no readings
    failed,       ///< it looks like a record, and could not be read
    delayed       ///< the database or the disk accepted nothing
  };
  std::string file;  ///< its name without the folder
  Kind kind = Kind::no_record;
  std::string words;           ///< the result of the test, or the reason
  std::int64_t test = 0;       ///< number; 0: none
  std::int64_t last_test = 0;  ///< of a file with several tests; else as `test`
};

/// Regular files of the folder that may be records, by name: without hidden files, databases with
/// what SQLite and triax keep beside them, and .toml files, which describe others. Folders in it
/// are not entered. Throws BadInput for a folder that cannot be read.
std::vector<std::string> files_of_folder(const std::string& folder);

class FolderReplay {
 public:
  /// `db` is the path of the database, which may not exist yet.
  FolderReplay(const ReplayRequest& request, std::string db);

  /// Reads all tests of one file but those that are stored as complete tests of the same bytes. A
  /// file of which this object stored the first part replaces the tests of that, unless they were
  /// renamed, tagged or corrected. Throws Stopped.
  FileOutcome read(const std::string& path, const Interruption& interruption);

  /// The tests and files of results that were stored.
  const std::vector<std::int64_t>& tests() const { return tests_; }
  const ReferenceFiles& references() const { return references_; }
  const std::string& db() const { return db_; }

 private:
  /// The stored tests of a file.
  struct Part {
    std::vector<db::StoredTest> tests;
    std::string digest;  ///< of the file
    std::uint64_t bytes = 0;
  };
  /// The results for the tests of a file.
  struct TestOutcomes {
    std::vector<db::StoredTest> stored;
    std::vector<std::int64_t> before;  ///< read before
    std::vector<std::string> faults;
  };

  FileOutcome read_record(const std::string& path, const Interruption& interruption);
  TestOutcomes read_tests(const std::string& path, const std::string& digest,
                          const Interruption& interruption);
  std::int64_t stored_before(const std::string& digest, const std::string& name) const;
  std::vector<std::int64_t> replaced_by(const std::string& path) const;
  static FileOutcome outcome_of(const TestOutcomes& tests);

  const ReplayRequest& request_;
  std::string db_;
  std::vector<std::int64_t> tests_;
  std::map<std::string, Part> parts_;  ///< by path
  ReferenceFiles references_;
};

/// The table of what became of the files, and a last line with the counts.
std::string outcome_table(const std::vector<FileOutcome>& outcomes);
/// "a.csv: test 4, flow"; "b.pdf: no record: ...".
std::string outcome_line(const FileOutcome& outcome);

}  // namespace triax::src
