// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/cli/command.hpp"

namespace triax::src {

/// triax rig check: what the instruments of a rig say, and what is wrong.
Command rig_command();

}  // namespace triax::src
