// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A stored test on its way to its next revision: one transaction, from the look at the newest
// revision to the commit of the next. Whatever ends it before, a kill included, leaves the test as
// it was.
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Transaction.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "db/corrections/first_header.hpp"
#include "db/revisions.hpp"
#include "db/scan_writer.hpp"
#include "db/store.hpp"
#include "lab/rig/session_listener.hpp"

namespace triax::db {

class Correction {
 public:
  /// Begins. Until the end of this object other programs read the newest revision and wait to
  /// write. Throws lab::BadInput if there is no such test, if it is running, was interrupted or has
  /// a lease, and if readings of it are missing; else as open_for_writing().
  Correction(const std::string& path, std::int64_t id);

  /// The newest revision.
  const StoredTest& test() const { return test_; }
  /// As first stored. A test of an older triax: of its newest revision, without what is not stored
  /// (vouched sensors, alternatives of assumptions).
  const FirstHeader& first() const { return first_; }
  /// Stages that the readings or the header have, ascending.
  const std::vector<int>& stages() const { return stages_; }
  /// True if that is all that a replay needs.
  bool is_exact() const { return is_exact_; }
  /// The readings, as they are while this object writes.
  const Store& readings() const { return *reader_; }

  /// The results of a session replace those that are stored: name, programme, specimen, stages,
  /// notes and assumptions of the header, states, second-order work, forecasts and events. Readings
  /// are written back as they were. As long as this object lives.
  lab::SessionListener listener();
  /// Adds the summary and the changes, and commits; gives the number of the revision. Its guard and
  /// truth are not replaced: no correction changes them.
  std::int64_t commit(lab::TestSummary summary, const std::vector<RevisedValue>& values);

 private:
  void check_can_be_corrected();
  void begin(const lab::RecordHeader& header);
  void write(const Scan& scan);
  template <class Work>
  auto guarded(const Work& work) const;
  void write_scans();

  std::string path_;
  std::int64_t id_;
  std::optional<Store> reader_;
  SQLite::Database database_;
  SQLite::Transaction transaction_;
  StoredTest test_;
  FirstHeader first_;
  std::vector<int> stages_;
  bool is_exact_ = true;
  std::vector<Scan> waiting_;
  std::optional<ScanWriter> scans_;
};

}  // namespace triax::db
