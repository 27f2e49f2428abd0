// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/commands.hpp"

#include "src/about/about.hpp"
#include "src/calibrate/calibrate.hpp"
#include "src/domain/domain.hpp"
#include "src/element/element.hpp"
#include "src/element/materials.hpp"
#include "src/export/export.hpp"
#include "src/grains/grains.hpp"
#include "src/page/open.hpp"
#include "src/probe/probe.hpp"
#include "src/soil/soil.hpp"
#include "src/triaxial/query.hpp"
#include "src/triaxial/replay/replay.hpp"
#include "src/triaxial/report.hpp"
#include "src/triaxial/simulate.hpp"
#include "src/triaxial/tests.hpp"
#include "src/wire/record.hpp"
#include "src/wire/rig.hpp"
#include "src/wire/run.hpp"
#include "src/wire/serve.hpp"

namespace triax::src {

const std::vector<Command>& commands() {
  static const std::vector<Command> all = {
      simulate_command(), replay_command(), report_command(),  query_command(),
      export_command(),   tests_command(),  element_command(), materials_command(),
      probe_command(),    domain_command(), soil_command(),    calibrate_command(),
      grains_command(),   serve_command(),  run_command(),     record_command(),
      rig_command(),      open_command(),   about_command()};
  return all;
}

}  // namespace triax::src
