// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/supervision.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "lab/devices/noise.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/rig_header.hpp"
#include "lab/rig/simulated/instruments.hpp"
#include "lab/rig/simulated/virtual_apparatus.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax::lab;
using Catch::Contains;

namespace {

/// A stage under supervision, look after look, with readings that a test may spoil.
class Watch {
 public:
  explicit Watch(const Stage& stage, double load_limit_n = 0)
      : programme_(read_programme(test::programme_text(), "p.toml")),
        plant_(programme_),
        instruments_(programme_, 1),
        seen_(rig_header(programme_, 1)),
        supervision_((programme_.frame.load_limit_n = load_limit_n, programme_)) {
    asked.cell_pa = 400e3;
    asked.back_pa = 300e3;
    instruments_.look(plant_, 0, reading);
    reading.time_s = 0;
    seen_.take(reading);
    supervision_.begin_stage(stage);
  }

  /// So many looks, a second apart; the first reason for the safe state, "" without one.
  std::string look(int times) {
    for (int i = 0; i < times; ++i) {
      reading.time_s += 1;
      seen_.take(reading);
      const auto reason = supervision_.look(reading, seen_, asked, devices, 1);
      for (auto& note : supervision_.notes()) notes += note + "\n";
      if (reason) return *reason;
    }
    return {};
  }

  Reading reading;
  Demanded asked;
  DeviceStates devices;
  std::string notes;

 private:
  Programme programme_;
  Plant plant_;
  Instruments instruments_;
  Seen seen_;
  Supervision supervision_;
};

Stage load_stage() {
  Stage stage;
  stage.axial = AxialAction::load;
  stage.end = {{EndQuantity::time, 1e4, {}}};
  return stage;
}

Stage crosshead_stage() {
  Stage stage;
  stage.axial = AxialAction::displacement;
  stage.end = {{EndQuantity::axial_strain, 0.1, {}}};
  return stage;
}

}  // namespace

TEST_CASE("a healthy rig is left alone") {
  Watch w(load_stage());
  w.asked.force_n = 0;
  CHECK(w.look(200).empty());
  CHECK(w.notes.empty());
}

TEST_CASE("a load cell that falls silent stops a stage by load, and is only told of in another") {
  Watch load(load_stage());
  load.reading[Quantity::axial_force] = kMissing;
  CHECK(load.look(2).empty());
  CHECK_THAT(load.look(2), Contains("axial_force gives no readings"));
  Watch crosshead(crosshead_stage());
  crosshead.reading[Quantity::axial_force] = kMissing;
  CHECK(crosshead.look(20).empty());
  CHECK_THAT(crosshead.notes, Contains("axial_force gives no readings from 1 s on"));
}

TEST_CASE("a force that does not come while the cap stands is a failure; a collapse is none") {
  Watch standing(load_stage());
  standing.asked.force_n = 100;
  CHECK_THAT(standing.look(30), Contains("instead of the 100.0 N prescribed"));
  Watch collapsing(load_stage());
  collapsing.asked.force_n = 100;
  std::string reason;
  for (int i = 0; i < 60 && reason.empty(); ++i) {
    collapsing.reading[Quantity::axial_displacement] += 0.1e-3;
    reason = collapsing.look(1);
  }
  CHECK(reason.empty());
}

TEST_CASE("a pressure that does not follow its controller's set point") {
  Watch w(crosshead_stage());
  w.asked.cell_pa = 410e3;
  CHECK(w.look(50).empty());
  CHECK_THAT(w.look(20), Contains("the cell pressure reads 400.0 kPa instead of the 410.0 kPa"));
  Watch by_volume(crosshead_stage());
  by_volume.asked.back_pa = 400e3;
  by_volume.asked.back_by_volume = true;
  CHECK(by_volume.look(200).empty());
}

TEST_CASE("a crosshead that moves and a displacement that does not") {
  Watch w(crosshead_stage());
  w.asked.crosshead_velocity = 1e-5;
  CHECK_THAT(w.look(100), Contains("the displacement reading changed by 0.000 mm"));
}

TEST_CASE("a controller at its end, and the emergency stop, which a spike does not set off") {
  Watch w(crosshead_stage());
  w.devices.back.empty = true;
  CHECK_THAT(w.look(1), Contains("back-pressure controller is empty"));
  Watch stop(crosshead_stage(), 500);
  stop.reading[Quantity::axial_force] = 600;
  CHECK(stop.look(1).empty());
  stop.reading[Quantity::axial_force] = 0;
  CHECK(stop.look(1).empty());
  stop.reading[Quantity::axial_force] = 600;
  CHECK_THAT(stop.look(2), Contains("emergency stop"));
}

TEST_CASE("water that flows through a closed valve is told of once") {
  Watch w(crosshead_stage());
  w.asked.valve_open = false;
  CHECK(w.look(2).empty());
  w.reading[Quantity::back_volume] = -400e-9;
  CHECK(w.look(5).empty());
  CHECK_THAT(w.notes, Contains("water flows although the valve is closed (-400 mm3"));
  CHECK(w.notes.find("closed") == w.notes.rfind("closed"));
}

TEST_CASE("spikes stop nothing and are not told of as water") {
  Watch w(crosshead_stage());
  w.asked.valve_open = false;
  w.asked.crosshead_velocity = 1e-5;
  for (int i = 0; i < 300; ++i) {
    const bool spike = i % 32 == 16;
    w.reading[Quantity::axial_displacement] = 1e-5 * i + (spike ? -2e-3 : 0);
    w.reading[Quantity::back_volume] = spike ? 2e-6 : 0;
    REQUIRE(w.look(1).empty());
  }
  CHECK(w.notes.empty());
}

TEST_CASE("a noisy load cell that stands still stops the stage that follows it, and no other") {
  for (const bool by_load : {true, false}) {
    Watch w(by_load ? load_stage() : crosshead_stage());
    if (by_load) w.asked.force_n = 100;
    const auto noise = [](std::uint64_t i) {
      return 0.1 * std::round(5 * standard_normal(1, 2, i));
    };
    for (std::uint64_t i = 0; i < 100; ++i) {
      w.reading[Quantity::axial_force] = 100 + noise(i);
      REQUIRE(w.look(1).empty());
    }
    const std::string reason = w.look(60);
    if (by_load) CHECK_THAT(reason, Contains("axial_force was at exactly"));
    if (!by_load) CHECK(reason.empty());
  }
}

TEST_CASE("a cell that takes water at rest, and a valve that does not open") {
  Watch cell(crosshead_stage());
  cell.asked.valve_open = false;
  CHECK(cell.look(5).empty());
  cell.reading[Quantity::cell_volume] = 3e-6;
  CHECK(cell.look(5).empty());
  CHECK_THAT(cell.notes, Contains("water flows into the cell although") && Contains("3000 mm3"));
  Watch ramping(crosshead_stage());
  ramping.asked.valve_open = false;
  for (int i = 0; i < 20; ++i) {
    ramping.asked.cell_pa += 100;
    ramping.reading[Quantity::cell_volume] += 1e-6;
    CHECK(ramping.look(1).empty());
  }
  CHECK(ramping.notes.empty());

  Watch blocked(crosshead_stage()), draining(crosshead_stage());
  for (Watch* w : {&blocked, &draining}) w->reading[Quantity::pore_pressure] += 20e3;
  for (int i = 0; i < 100; ++i) {
    CHECK(blocked.look(1).empty());
    draining.reading[Quantity::back_volume] -= 1e-9;
    CHECK(draining.look(1).empty());
  }
  CHECK_THAT(blocked.notes, Contains("no water flows"));
  CHECK(draining.notes.empty());
}

TEST_CASE("a channel at the end of its range or silent ends no stage") {
  Programme p = read_programme(test::programme_text(), "p.toml");
  p.faults = {{"axial_displacement", FaultKind::drop_out, 1, {}, 0}};
  VirtualApparatus rig(p, 1);
  Reading reading;
  reading.time_s = 0;
  rig.look(reading);
  CHECK(Supervision::can_tell(EndQuantity::axial_strain, reading, rig.devices()));
  reading.time_s = 1;
  rig.look(reading);
  CHECK_FALSE(Supervision::can_tell(EndQuantity::axial_strain, reading, rig.devices()));
  CHECK(Supervision::can_tell(EndQuantity::time, reading, rig.devices()));
}
