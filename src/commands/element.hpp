#pragma once
#include "src/commands/command.hpp"

namespace triax::src {

Command element_command();

}  // namespace triax::src
