// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Controllability of one state as text and tables.
#include <string>

#include "src/output/table.hpp"
#include "src/study/probe/controllability.hpp"

namespace triax::src {

/// "loading" where σ₁′ − σ₃′/R grows.
const char* sense_words(sim::ControlSense sense);
/// "held", "lost" or "unanswered".
std::string state_name(sim::ControlState state);
/// "q_kPa = 1, axial_strain = 0: lost, axial_strain cannot be held".
std::string condition_words(const sim::ControlIndex& at);
/// "loading lost for R 0.4488 to 1.0177"; "held for R 0.05 to 5, loading and unloading".
std::string lost_in_words(const study::Controllability& control);
/// "R 0.2537 (α 250.3°, dε₁/dσ₃ ...)" for each root.
std::string roots_in_words(const study::Controllability& control);
Table scan_table(const study::Controllability& control);
Table named_controls_table(const study::Controllability& control);

}  // namespace triax::src
