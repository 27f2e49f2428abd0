#pragma once
#include "src/commands/command.hpp"

namespace triax::src {

Command simulate_command();

}  // namespace triax::src
