// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/cli/command.hpp"

namespace triax::src {

/// triax run: a programme on instruments.
Command run_command();

}  // namespace triax::src
