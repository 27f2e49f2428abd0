#pragma once
#include "src/commands/command.hpp"

namespace triax::src {

Command materials_command();

}  // namespace triax::src
