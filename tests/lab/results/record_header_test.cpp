// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/record_header.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("names of roles, drainages and controls read back as what they name") {
  for (const auto role : {StageRole::unknown, StageRole::saturation, StageRole::b_check,
                          StageRole::consolidation, StageRole::shear})
    CHECK(stage_role_from(to_string(role)) == role);
  for (const auto drainage : {Drainage::unknown, Drainage::open, Drainage::closed})
    CHECK(drainage_from(to_string(drainage)) == drainage);
  for (const auto control : {AxialControl::unknown, AxialControl::displacement, AxialControl::load,
                             AxialControl::constant_q})
    CHECK(axial_control_from(to_string(control)) == control);
  CHECK_FALSE(stage_role_from("Shear"));
  CHECK(run_away_end_from("") == RunAwayEnd::none);
  CHECK(run_away_end_from("new equilibrium") == RunAwayEnd::new_equilibrium);
  CHECK(run_away_end_from("end of travel") == RunAwayEnd::end_of_travel);
  CHECK(to_string(RunAwayEnd::end_of_travel) == "end of travel");
  CHECK_FALSE(run_away_end_from("travel"));
}

TEST_CASE("a record is raw with displacement, force and cell pressure together") {
  RecordHeader header;
  header.columns = {Quantity::axial_displacement, Quantity::axial_force};
  CHECK_FALSE(header.is_raw());
  header.columns.push_back(Quantity::cell_pressure);
  CHECK(header.is_raw());
  header.stages.resize(2);
  header.stages[1].number = 5;
  CHECK(header.stage(5) == &header.stages[1]);
  CHECK(header.stage(2) == nullptr);
}
