#pragma once
#include "src/cli/command.hpp"

namespace triax::src {

Command grains_command();

}  // namespace triax::src
