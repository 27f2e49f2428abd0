// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/cli/command.hpp"

namespace triax::src {

/// triax record: reads instruments and keeps what they say.
Command record_command();

}  // namespace triax::src
