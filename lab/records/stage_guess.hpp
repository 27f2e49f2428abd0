// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What was taken for a stage that a record does not describe, in words.
#include "lab/records/stage_inference.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// Role, drainage and control as inferred, with what moved in the stage as evidence and the --set
/// that says otherwise.
Guess stage_guess(const StageSummary& moved, const StageInfo& inferred,
                  const SpecimenInfo& specimen);

/// The drainage of a record's only stage, taken from what its columns are or did.
Guess drainage_guess(const StageInfo& inferred, const std::string& evidence);

}  // namespace triax::lab
