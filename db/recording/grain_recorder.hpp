// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "db/recording/patience.hpp"
#include "lab/grains/grain_run.hpp"

namespace triax::db {

/// Writes one run of grains into the database: the specimen when it is made, each stage when it is
/// over, so that a kill loses at most the stage under way and others can read meanwhile. Nothing is
/// touched on disk before the specimen is made.
///
/// A database that takes nothing (the lock of another program, a full disk) is waited for as long
/// as Patience::most; the run stands still meanwhile.
///
/// Throws lab::BadInput (no database of ours), lab::WorkFailed (waited for too long); what was
/// committed before stands.
class GrainRecorder {
 public:
  /// `programme` has to outlive it.
  GrainRecorder(std::string path, const lab::GrainProgramme& programme, Patience patience = {});
  ~GrainRecorder();  ///< a run that was not finished stays behind as interrupted
  GrainRecorder(const GrainRecorder&) = delete;
  GrainRecorder& operator=(const GrainRecorder&) = delete;

  /// What a run tells, into the database; as long as this recorder lives.
  lab::GrainListener listener();
  void made(const lab::GrainsMade& made);
  /// After made(). All of the stage or nothing.
  void ended(const lab::GrainStageResult& result);
  /// The run is complete; gives its id.
  std::int64_t finish();
  /// Of the run; 0 before made().
  std::int64_t id() const;
  /// Of the database that has the run: in the new place of its folder where that was renamed.
  const std::string& path() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace triax::db
