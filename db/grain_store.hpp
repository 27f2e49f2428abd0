// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Runs of grains in the database (GrainRecorder writes them), also while they are written.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "db/store.hpp"
#include "lab/grains/grain_report.hpp"

namespace triax::db {

struct StoredGrainRun {
  std::int64_t id = 0;
  TestStatus status = TestStatus::running;
  std::optional<SignOfLife> sign_of_life;  ///< empty: complete, or of an older triax
  std::string recorded_at;                 ///< ISO 8601, UTC
  lab::GrainReport report;                 ///< of an interrupted run the stages that had ended
  /// False: an older version wrote it, and what it did not store is not known (grain_report.hpp).
  bool whole = true;
};

/// One thread at a time.
class GrainStore {
 public:
  /// As Store.
  explicit GrainStore(const std::string& path);
  ~GrainStore();
  GrainStore(const GrainStore&) = delete;
  GrainStore& operator=(const GrainStore&) = delete;

  /// Ids of all runs, oldest first.
  std::vector<std::int64_t> all() const;
  /// The run of this id or name, the latest of several with one name; a run called "3" goes before
  /// the third. Empty where there is none.
  std::optional<std::int64_t> find(const std::string& name) const;
  /// Throws lab::BadInput if there is none of that id.
  StoredGrainRun load(std::int64_t id) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace triax::db
