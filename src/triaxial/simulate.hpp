#pragma once
#include "src/cli/command.hpp"

namespace triax::src {

Command simulate_command();

}  // namespace triax::src
