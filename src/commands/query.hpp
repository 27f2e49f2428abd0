#pragma once
#include "src/commands/command.hpp"

namespace triax::src {

Command query_command();

}  // namespace triax::src
