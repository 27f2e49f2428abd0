// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/otherwise.hpp"

#include "lab/base/bad_input.hpp"

namespace triax::lab {

std::vector<Otherwise> judge_otherwise(const RecordHeader& header,
                                       const ReductionOptions& reduction,
                                       const OpenOtherwise& open) {
  std::vector<Otherwise> all;
  for (const Guess& guess : header.guesses)
    for (const Guess::Said& said : guess.otherwise) {
      try {
        const auto rig = open(said);
        all.push_back({.taken = guess.what + " was assumed to be " + guess.taken,
                       .said = said.key + "=" + said.value,
                       .collapse = run_session(*rig, {.reduction = reduction}).collapse});
      } catch (const BadInput&) {
        continue;
      }
    }
  return all;
}

}  // namespace triax::lab
