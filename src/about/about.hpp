// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/cli/command.hpp"

namespace triax::src {

/// `triax about`: version, licence and source; with --rules the table of rules of an assessment and
/// its limits.
Command about_command();

}  // namespace triax::src
