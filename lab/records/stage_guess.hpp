// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The assumptions about a stage that a record does not describe, in words, and the evidence of its
// readings for the drainage.
#include <span>
#include <string>
#include <vector>

#include "lab/records/stage_inference.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// Role, drainage and control as inferred, with what moved in the stage as evidence and the --set
/// that says otherwise.
Guess stage_guess(const StageSummary& moved, const StageInfo& inferred,
                  const SpecimenInfo& specimen);

/// Has the record assessed with the other drainage as well: the readings do not show it.
void ask_other_drainage(Guess& guess, const StageInfo& inferred);

/// The drainage of a record's only stage, taken from what its columns are or did.
Guess drainage_guess(const StageInfo& inferred, const std::string& evidence);

/// That all readings of a record without a stage column belong to its only stage, `only`.
Guess single_stage_guess(const StageInfo& only);

/// The stages of a record without a stage column as its readings show them, with their first lines.
Guess split_guess(const std::vector<StageInfo>& stages, std::span<const std::int64_t> lines);

struct DrainageEvidence {
  Drainage drainage = Drainage::unknown;  ///< unknown: the readings do not show it
  std::string text;                       ///< evidence, with numbers and units; may be empty
};

/// From the stresses, where q changed by 5 kPa or more (Δq; of raw channels F over the area of
/// `specimen`), and from the volumetric strain:
///   open    ε_v changed by more than 0.1 %; or σ₃' changed by less than 3 % of Δq, and u, where it
///           was read too: in an undrained test σ₃' follows the pore pressure
///   closed  u changed by more than 10 % of Δq, while σ₃' + u changed by less than 3 % of Δq; or
///           ε_v changed by less than 0.01 %
/// A path at constant p' or q changes σ₃' and may be either.
DrainageEvidence find_drainage(const StageSummary& shear, const SpecimenInfo& specimen);

}  // namespace triax::lab
