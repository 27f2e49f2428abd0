// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A record read once more, with the other answer to what was guessed of it.
#include <functional>
#include <memory>
#include <vector>

#include "lab/rig/back_end.hpp"
#include "lab/rig/session.hpp"

namespace triax::lab {

/// Opens the record with one more --set.
using OpenOtherwise = std::function<std::unique_ptr<BackEnd>(const Guess::Said& said)>;

/// What the record comes to with each answer of header.guesses[].otherwise, one run each, told to
/// nobody. An answer with which it cannot be read is left out.
std::vector<Otherwise> judge_otherwise(const RecordHeader& header,
                                       const ReductionOptions& reduction,
                                       const OpenOtherwise& open);

}  // namespace triax::lab
