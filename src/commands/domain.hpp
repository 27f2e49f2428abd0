#pragma once
#include "src/commands/command.hpp"

namespace triax::src {

Command domain_command();

}  // namespace triax::src
