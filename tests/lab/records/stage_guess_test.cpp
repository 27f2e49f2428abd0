// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/stage_guess.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;
using Catch::Contains;

TEST_CASE("a guess says what was taken, what speaks for it, and how to say otherwise") {
  StageSummary moved;
  moved.number = 5;
  for (const double x : {0.0, 1.0}) {
    Row row;
    row.si.fill(kMissing);
    row.si[index(Quantity::axial_displacement)] = x * 4.2e-3;
    row.si[index(Quantity::back_volume)] = 3e-9;
    moved.add(row);
  }
  const StageInfo shear{.number = 5,
                        .role = StageRole::shear,
                        .drainage = Drainage::closed,
                        .control = AxialControl::displacement};
  const Guess guess = stage_guess(moved, shear, {});
  CHECK(guess.what == "stage 5");
  CHECK(guess.taken == "shear, drainage closed, displacement prescribed");
  CHECK(guess.evidence == "changed: the displacement by 4.2 mm, the back volume by 0 mm3");
  CHECK(guess.remedy == "--set stages.5.role=... and --set stages.5.drainage=open");

  StageInfo unsaid = shear;
  unsaid.control = AxialControl::unknown;
  CHECK(stage_guess(moved, unsaid, {}).taken ==
        "shear, drainage closed, control of the axis unknown");
  CHECK(stage_guess(moved, unsaid, {}).remedy ==
        "--set stages.5.role=... and --set stages.5.drainage=open and "
        "--set stages.5.control=displacement, load or constant_q");

  const Guess drainage = drainage_guess({.number = 1, .drainage = Drainage::open}, "because");
  CHECK(drainage.taken == "open");
  CHECK(drainage.remedy == "--set stages.1.drainage=closed");
}
