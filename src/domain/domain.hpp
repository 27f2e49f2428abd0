#pragma once
#include "src/cli/command.hpp"

namespace triax::src {

Command domain_command();

}  // namespace triax::src
