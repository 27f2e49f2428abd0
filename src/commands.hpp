// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "src/cli/command.hpp"

namespace triax::src {

/// All commands, in the order of --help. A new command is a file pair in its slice and a line in
/// commands.cpp.
const std::vector<Command>& commands();

}  // namespace triax::src
