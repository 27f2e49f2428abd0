// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "db/store.hpp"
#include "src/output/fact.hpp"

namespace triax::src {

/// From the verdict to the truth: onset, alarm, failure, peak, guard, limit surface, runaways.
void add_collapse(std::vector<Fact>& facts, const db::StoredTest& test);

/// Of a simulated specimen itself.
std::string truth_line(const lab::Truth& truth);

}  // namespace triax::src
