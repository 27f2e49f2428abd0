// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/cli/command.hpp"

namespace triax::src {

/// triax tests [ACTION [ID...]]: lists, shows, renames, tags and removes tests.
Command tests_command();

}  // namespace triax::src
