// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a sweep says of itself once it is over.
#include <string>
#include <vector>

#include "src/study/sweep/sweep_run.hpp"

namespace triax::src {

/// One line a test, up to a limit; then over all tests how many lost sustainability and how many
/// were detected, η at collapse (mean, least, largest, standard deviation), and the same against
/// the truth. Says that all of it is simulated. Failed tests are counted here and told by
/// sweep_failures().
std::string sweep_text(const lab::Sweep& sweep, const std::vector<study::SweepMember>& members);

/// Why tests failed, each with its values, in the order of the sweep; many are cut short.
std::vector<std::string> sweep_failures(const lab::Sweep& sweep,
                                        const std::vector<study::SweepMember>& members);

/// Prints the documents of all stored tests as one JSON array, in the order of the sweep; holds one
/// test at a time.
void print_sweep_json(const std::string& db, const std::vector<study::SweepMember>& members);

}  // namespace triax::src
