// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One record on its way into the database, as `triax replay` does it for files, folders and a
// folder that is watched.
#include <memory>
#include <string>
#include <vector>

#include "lab/base/bad_input.hpp"
#include "lab/records/stated/job_file.hpp"
#include "lab/reduction/reduction.hpp"
#include "lab/rig/recorded.hpp"
#include "lab/warning/earlier_tests.hpp"
#include "src/cli/interruption.hpp"
#include "src/study/triaxial/tests_of_file.hpp"

namespace triax::src {

/// Ctrl-C or SIGTERM during a record: the test is stored as interrupted.
struct Stopped : lab::WorkFailed {
  Stopped()
      : WorkFailed(
            "stopped by the operator; this record is stored as interrupted, the records after it "
            "were not read") {}
};

using study::TestOfFile;

/// Values that are the same for all records of a call.
struct ReplayRequest {
  lab::RecordOptions record;  ///< without the values of the job
  lab::JobFile job;
  lab::ReductionOptions reduction;
  double speed = 0;
  lab::EarlierTests earlier{};

  /// With the values that the job has for this record.
  lab::RecordOptions options_for(const std::string& path, const TestOfFile& test = {}) const;
  /// lab::tests_in() of this record.
  study::FindTests tests_in(const std::string& path) const;
};

/// Opens the record and checks that it can be reduced. Throws BadInput as open_record().
std::unique_ptr<lab::RecordedRig> open_to_replay(const ReplayRequest& request,
                                                 const std::string& path,
                                                 const TestOfFile& test = {});

/// Replays `rig`, which was opened from `path`, into the database; gives the number of the test.
/// `db` is the path of the database that has the test afterwards. Throws BadInput, after which
/// nothing of it is stored, WorkFailed, and Stopped after an interruption.
std::int64_t replay_record(const ReplayRequest& request, const std::string& path,
                           lab::RecordedRig& rig, std::string& db, const Interruption& interruption,
                           const TestOfFile& test = {});

}  // namespace triax::src
