// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/cli/command.hpp"

namespace triax::src {

Command replay_command();

}  // namespace triax::src
