#include "src/commands/command.hpp"

#include "src/commands/domain.hpp"
#include "src/commands/element.hpp"
#include "src/commands/grains.hpp"
#include "src/commands/materials.hpp"
#include "src/commands/probe.hpp"
#include "src/commands/query.hpp"
#include "src/commands/replay.hpp"
#include "src/commands/report.hpp"
#include "src/commands/simulate.hpp"

namespace triax::src {

const std::vector<Command>& commands() {
  static const std::vector<Command> all = {
      simulate_command(),  replay_command(), report_command(), query_command(), element_command(),
      materials_command(), probe_command(),  domain_command(), grains_command()};
  return all;
}

}  // namespace triax::src
