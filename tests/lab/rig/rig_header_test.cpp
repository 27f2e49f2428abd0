// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/rig_header.hpp"

#include <catch2/catch.hpp>

#include "lab/programmes/programme_reader.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax::lab;

TEST_CASE("the record of a programme has one stage more, for a rig that is held") {
  Programme p = read_programme(test::programme_text(), "p.toml");
  p.stages[0].strain_path_R = 0.7;
  p.faults.push_back({.device = "valve", .kind = FaultKind::does_not_close, .from_s = 60});
  const RecordHeader h = rig_header(p, 5);
  REQUIRE(h.stages.size() == 2);
  CHECK(h.stages[0].strain_path_R == 0.7);
  CHECK(h.stages[1].number == 2);
  CHECK(h.stages[1].role == StageRole::hold);
  CHECK(h.seed == 5);
  REQUIRE(h.warnings.size() == 1);
  CHECK(h.warnings[0].text == describe(p.faults[0]));
  CHECK_FALSE(h.specimen.membrane_thickness_m);
}

TEST_CASE("whatever follows a force is load control to a record") {
  Programme p = read_programme(test::programme_text(), "p.toml");
  for (const auto& [action, control] :
       {std::pair{AxialAction::dead_load, AxialControl::load},
        std::pair{AxialAction::spring, AxialControl::load},
        std::pair{AxialAction::stress_ratio, AxialControl::load},
        std::pair{AxialAction::constant_q, AxialControl::constant_q},
        std::pair{AxialAction::hold, AxialControl::displacement}}) {
    p.stages[0].axial = action;
    CHECK(rig_header(p, 1).stages[0].control == control);
  }
}
