// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the header of a record says of a stage that ended otherwise than at one of its ends.
#include <string>

#include "lab/programmes/programme.hpp"
#include "sim/specimen/specimen.hpp"

namespace triax::lab {

std::string out_of_time(const Stage& stage);
std::string ended_by_guard(const Stage& stage, double time_s, const std::string& what_it_did);
std::string ended_in_safe_state(const Stage& stage, double time_s, const std::string& why);
/// The law has no result beyond the state of this step, which began at `time_s`.
std::string ended_by_law(const Stage& stage, double time_s, const sim::SpecimenStep& step);
/// The specimen cannot follow the control beyond what the step did.
std::string control_lost(const Stage& stage, double time_s, const sim::SpecimenStep& step);
/// `displaced_m`: of the crosshead since the start of the test, < 0 in extension.
std::string travel_reached(const Stage& stage, double time_s, double travel_m, double displaced_m);

}  // namespace triax::lab
