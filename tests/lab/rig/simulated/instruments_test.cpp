// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/simulated/instruments.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/rig/simulated/virtual_rig.hpp"
#include "tests/lab/rig/rig_text.hpp"

using namespace triax;
using namespace triax::lab;
using namespace triax::lab::test;

namespace {

const std::string kStage =
    shear_stage("closed", "displacement", "axial_rate_mm_per_min = 1.0", R"("q_kPa", above = 1.0)");

Programme with_transducers(const std::string& lines) {
  return rig_programme(kStage, kIdealFrame + lines);
}

Reading at(Instruments& instruments, const Plant& plant, double time_s) {
  Reading reading;
  instruments.look(plant, time_s, reading);
  return reading;
}

}  // namespace

TEST_CASE("perfect instruments say what is true, of every channel") {
  const Programme programme = with_transducers("");
  const Plant plant(programme);
  Instruments instruments(programme, 1);
  const Reading reading = at(instruments, plant, 0);
  for (const QuantityInfo& row : raw_channels()) {
    const Quantity channel = row.quantity;
    if (!programme.fitted[index(channel)]) continue;
    CHECK(reading[channel] == Approx(plant.true_value(channel)).epsilon(1e-12).margin(1e-15));
    CHECK_FALSE(instruments.saturated(channel));
  }
}

TEST_CASE("a rig without a channel neither reads it nor takes its silence for a fault") {
  Programme programme = with_transducers("");
  programme.fitted[index(Quantity::cell_volume)] = false;
  VirtualRig rig(programme);
  CHECK_FALSE(rig.header().has(Quantity::cell_volume));
  CHECK(rig.header().has(Quantity::back_volume));
  for (const Reading& reading : all_readings(rig)) {
    CHECK_FALSE(reading.has(Quantity::cell_volume));
    CHECK(reading.has(Quantity::back_volume));
  }
  CHECK(rig.header().warnings.empty());
  for (const Event& event : rig.events()) CHECK(event.kind != EventKind::device_fault);
}

TEST_CASE("an offset is that of its own channel, and a range ends where it ends") {
  const Programme programme = with_transducers(
      "[rig.transducers.pore_pressure]\noffset_kPa = 2.0\n[rig.transducers.cell_pressure]\n"
      "range_kPa = 390.0\n");
  const Plant plant(programme);
  Instruments instruments(programme, 1);
  const Reading reading = at(instruments, plant, 0);
  CHECK(reading[Quantity::pore_pressure] == Approx(302e3));
  CHECK(reading[Quantity::back_pressure] == 300e3);
  CHECK(reading[Quantity::cell_pressure] == 390e3);
  CHECK(instruments.saturated(Quantity::cell_pressure));
  CHECK_FALSE(instruments.saturated(Quantity::pore_pressure));
}

TEST_CASE(
    "noise depends on seed, channel and number of the sample, not on what other channels do") {
  const std::string noise = "[rig.transducers.pore_pressure]\nnoise_kPa = 0.5\n";
  const Programme alone = with_transducers(noise),
                  beside =
                      with_transducers(noise + "[rig.transducers.axial_force]\nnoise_N = 1.0\n");
  const Plant plant(alone);
  Instruments one(alone, 7), two(beside, 7), other(alone, 8);
  bool differs = false;
  for (int i = 0; i < 20; ++i) {
    const double seen = at(one, plant, i)[Quantity::pore_pressure];
    CHECK(at(two, plant, i)[Quantity::pore_pressure] == seen);
    CHECK(std::fabs(seen - 300e3) < 5 * 0.5e3);
    differs = differs || at(other, plant, i)[Quantity::pore_pressure] != seen;
  }
  CHECK(differs);
}

TEST_CASE("a fault spoils its channel from its time to its end, and no other") {
  Programme programme = with_transducers("");
  programme.faults = {
      {.device = "pore_pressure", .kind = FaultKind::drop_out, .from_s = 2, .until_s = 4}};
  const Plant plant(programme);
  Instruments instruments(programme, 1);
  for (int i = 0; i < 6; ++i) {
    const Reading reading = at(instruments, plant, i);
    CHECK(std::isnan(reading[Quantity::pore_pressure]) == (i == 2 || i == 3));
    CHECK(reading[Quantity::cell_pressure] == 400e3);
  }
}
