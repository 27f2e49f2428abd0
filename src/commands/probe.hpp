#pragma once
#include "src/commands/command.hpp"

namespace triax::src {

Command probe_command();

}  // namespace triax::src
