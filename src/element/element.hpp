#pragma once
#include "src/cli/command.hpp"

namespace triax::src {

Command element_command();

}  // namespace triax::src
