// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/cli/command.hpp"

namespace triax::src {

/// triax serve: the instruments of a virtual rig on the wire.
Command serve_command();

}  // namespace triax::src
