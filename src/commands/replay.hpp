#pragma once
#include "src/commands/command.hpp"

namespace triax::src {

Command replay_command();

}  // namespace triax::src
