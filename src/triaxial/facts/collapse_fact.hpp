// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "db/store.hpp"
#include "src/output/fact.hpp"

namespace triax::src {

/// From the assessment to the truth: onset, loss of control, alarm, failure, peak, guard, limit
/// surface, runaways.
void add_collapse(std::vector<Fact>& facts, const db::StoredTest& test);

/// "detected at reading 330, 33.0 s; 5 readings later", of an onset or a loss of control.
std::string detected_line(const lab::Instant& at, const std::optional<lab::Moment>& detected_at);

/// Of a simulated specimen itself.
std::string truth_line(const lab::Truth& truth);

}  // namespace triax::src
