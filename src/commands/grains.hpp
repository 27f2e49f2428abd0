#pragma once
#include "src/commands/command.hpp"

namespace triax::src {

Command grains_command();

}  // namespace triax::src
