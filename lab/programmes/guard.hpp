// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The guard of a programme: what the rig does by itself when the alarm says that the specimen is
// about to be lost.
#include <string_view>

#include "lab/results/forecast.hpp"

namespace triax::lab {

class TomlTable;
struct Programme;
struct Stage;

struct Guard {
  enum class Action {
    hand_over,  ///< the crosshead takes the load from cylinder, masses or spring and goes on
    hold,       ///< it takes the load and stands
    unload,     ///< it takes the load and goes back until a share of q is taken off, then stands
    safe,       ///< the safe state
  };
  WarningLevel on = WarningLevel::imminent;  ///< at this level or above
  Action action = Action::hand_over;
  double rate_m_per_s = 0;       ///< hand_over, unload: of the crosshead, above 0
  double further_strain = 0.02;  ///< hand_over: axial strain until the test ends
  double share = 0.2;            ///< unload: of q
  double hold_s = 600;           ///< hold, unload: until the test ends, unless somebody resumes it
};
/// "hand_over".
std::string_view to_string(Guard::Action action);

/// Whether the guard does anything in that stage: shear with a piston, and for hand_over something
/// else than the crosshead that holds it.
bool guards(const Guard& guard, const Stage& stage);

/// Reads the table [guard] after the stages. Throws BadInput, also where no stage is guarded.
Guard read_guard(const TomlTable& table, const Programme& programme);

}  // namespace triax::lab
