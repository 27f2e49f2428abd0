// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/cli/command.hpp"

namespace triax::src {

/// What many tests of one soil say together.
Command soil_command();

}  // namespace triax::src
