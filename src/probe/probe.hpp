#pragma once
#include "src/cli/command.hpp"

namespace triax::src {

Command probe_command();

}  // namespace triax::src
