// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From what sets of parameters answer to what is told of them.
#include <string>
#include <vector>

#include "src/study/calibrate/implied_domain.hpp"
#include "src/study/calibrate/implied_states.hpp"

namespace triax::study {

/// What one set answers, column by column; empty columns where it answers nothing.
struct Answers {
  std::vector<sim::DomainColumn> compression, extension;
  std::string refusal;  ///< the law's words on directions that it refuses; empty: it answers all
};

/// Boundaries, cones and why there are none, into `out`, whose `confidence` says how wide the
/// intervals are; fewer than ten draws that have a number give none.
void tell_answers(const ImpliedStates& at, const Answers& best, const std::vector<Answers>& draws,
                  ImpliedDomain& out);

}  // namespace triax::study
