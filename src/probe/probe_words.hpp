// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Probes and their cones in words, as texts, captions and tables have them.
#include <string>
#include <vector>

#include "src/study/probe/probed_state.hpp"

namespace triax::src {

/// "stress of 1 kPa every 10°, by the rate at the state".
std::string probing_words(const study::Probing& probing);
/// "axisymmetric, α from √2 dσ₃ towards dσ₁ (Rendulic plane)".
std::string plane_words(sim::ProbePlane plane);
/// "214.86–237.66" for every cone, "none" without any.
std::string cones_in_words(const std::vector<sim::Cone>& cones);
/// The same of a circle with so many steps: without a cone, "unknown" where none was answered, and
/// "none found in the 30 answered" where not all were.
std::string cones_in_words(const sim::Circle& circle, int directions);
/// "3 beyond the law's limit, 2 refused by it (its words)"; empty where all are answered.
std::string unanswered_words(const study::ProbedState& state, int directions);

}  // namespace triax::src
