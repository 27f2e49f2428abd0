#pragma once
#include "src/commands/command.hpp"

namespace triax::src {

Command report_command();

}  // namespace triax::src
