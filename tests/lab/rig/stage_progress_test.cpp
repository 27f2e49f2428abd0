// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/stage_progress.hpp"

#include <catch2/catch.hpp>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/rig_header.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax::lab;

TEST_CASE("a stage has come as far as its nearest end, from where it began") {
  Seen seen(rig_header(read_programme(test::programme_text(), "p.toml"), 1));
  const auto look = [&](double cell_pa, double back_pa) {
    Reading reading;
    reading[Quantity::cell_pressure] = cell_pa;
    reading[Quantity::back_pressure] = back_pa;
    seen.take(reading);
  };
  Stage stage;
  stage.end.resize(2);
  stage.end[0].quantity = EndQuantity::cell_pressure;
  stage.end[0].above = 500e3;
  stage.end[1].quantity = EndQuantity::back_pressure;
  stage.end[1].below = 100e3;
  StageProgress progress;
  look(300e3, 200e3);
  progress.begin_stage(seen);
  CHECK(progress.share(stage, seen) == 0);
  look(350e3, 210e3);  // the other goes away from its end
  CHECK(progress.share(stage, seen) == Approx(0.25));
  look(350e3, 120e3);
  CHECK(progress.share(stage, seen) == Approx(0.8));
  look(900e3, 120e3);
  CHECK(progress.share(stage, seen) == 1);
  stage.end = {};
  CHECK(progress.share(stage, seen) == 0);
}
