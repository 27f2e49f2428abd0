// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/stage_split.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <vector>

#include "lab/devices/noise.hpp"

using namespace triax::lab;

namespace {

/// A specimen of 100 mm by 50 mm: 196350 mm³, 1963.5 mm².
SpecimenInfo split_specimen() {
  SpecimenInfo info;
  info.height_m = 0.1;
  info.diameter_m = 0.05;
  return info;
}

/// Readings as a laboratory logs them, kPa and mm³.
struct LoggedRows {
  StageSplit split;
  std::int64_t line = 0;
  double q = 0, cell = 320, pore = 300, back = 300, volume = 0;
  double volume_noise = 0;

  /// `count` rows during which the values change by these, linearly.
  void go(int count, LoggedRows by) {
    const LoggedRows start = values();
    for (int i = 1; i <= count; ++i) {
      const double x = static_cast<double>(i) / count;
      q = start.q + x * by.q;
      cell = start.cell + x * by.cell;
      pore = start.pore + x * by.pore;
      back = start.back + x * by.back;
      volume = start.volume + x * by.volume;
      add();
    }
  }
  void add() {
    const auto noise = [&](std::uint64_t channel) {
      return standard_normal(1, channel, static_cast<std::uint64_t>(line));
    };
    Row row;
    row.si.fill(kMissing);
    row.line = ++line;
    row.si[index(Quantity::axial_force)] = 1e3 * (q + 0.1 * noise(1)) * 1963.5e-6;
    row.si[index(Quantity::cell_pressure)] = 1e3 * (cell + 0.1 * noise(2));
    row.si[index(Quantity::pore_pressure)] = 1e3 * (pore + 0.1 * noise(3));
    row.si[index(Quantity::back_pressure)] = 1e3 * (back + 0.1 * noise(4));
    row.si[index(Quantity::back_volume)] = 1e-9 * (volume + volume_noise * noise(5));
    split.add(row);
  }
  LoggedRows values() const {
    LoggedRows copy;
    copy.q = q, copy.cell = cell, copy.pore = pore, copy.back = back, copy.volume = volume;
    return copy;
  }
  std::vector<StageSplit::Stage> stages() const { return split.stages(split_specimen()); }
};

LoggedRows change_of(double q, double cell, double pore, double back, double volume) {
  LoggedRows change;
  change.q = q, change.cell = cell, change.pore = pore, change.back = back, change.volume = volume;
  return change;
}

/// B check, taken back, and consolidation to 200 kPa: 200 rows.
LoggedRows consolidated_rows() {
  LoggedRows log;
  log.go(20, change_of(0, 30, 30, 0, 0));
  log.go(20, change_of(0, -30, -30, 0, 0));
  log.go(100, change_of(0, 180, 0, 0, -4000));
  log.go(60, change_of(0, 0, 0, 0, -200));
  return log;
}

}  // namespace

TEST_CASE("StageSplit: consolidation and undrained shear") {
  LoggedRows log = consolidated_rows();
  log.go(300, change_of(120, 0, 130, 0, 0));
  const auto stages = log.stages();
  REQUIRE(stages.size() == 4);
  for (const std::size_t check : {0, 1}) {
    CHECK(stages[check].role == StageRole::unknown);
    CHECK(stages[check].drainage == Drainage::closed);
  }
  CHECK(stages[1].line == Approx(20).margin(2));
  CHECK(stages[2].role == StageRole::consolidation);
  CHECK(stages[2].line == Approx(41).margin(2));
  CHECK(stages[3].role == StageRole::shear);
  CHECK(stages[3].drainage == Drainage::closed);
  CHECK(stages[3].line == Approx(200).margin(4));
}

TEST_CASE("StageSplit: consolidation and drained shear differ in the load alone") {
  LoggedRows log = consolidated_rows();
  log.go(300, change_of(250, 0, 0, 0, -3000));
  const auto stages = log.stages();
  REQUIRE(stages.size() == 4);
  CHECK(stages[3].role == StageRole::shear);
  CHECK(stages[3].drainage == Drainage::open);
  CHECK(stages[3].line == Approx(200).margin(4));
}

TEST_CASE("StageSplit: a record that begins with shear is one stage with its drainage") {
  const auto drainage_of = [](LoggedRows change, double noise) {
    LoggedRows log;
    log.cell = 500;
    log.volume_noise = noise;
    log.go(300, std::move(change));
    const auto stages = log.stages();
    REQUIRE(stages.size() == 1);
    CHECK(stages[0].role == StageRole::shear);
    return stages[0].drainage;
  };
  CHECK(drainage_of(change_of(120, 0, 130, 0, 0), 0) == Drainage::closed);
  CHECK(drainage_of(change_of(250, 0, 0, 0, -3000), 0) == Drainage::open);
  // The noise of the gauge is no flow, and a little water beside much pore pressure is none either.
  CHECK(drainage_of(change_of(120, 0, 130, 0, 0), 10) == Drainage::closed);
  CHECK(drainage_of(change_of(120, 0, 130, 0, -40), 0) == Drainage::closed);
  // The controller follows u: the difference counts.
  CHECK(drainage_of(change_of(100, 0, 100, 100, -3000), 0) == Drainage::open);
  // Neither moves, or both do.
  CHECK(drainage_of(change_of(100, 0, 0, 0, 0), 0) == Drainage::unknown);
  CHECK(drainage_of(change_of(100, 0, 100, 0, -1000), 0) == Drainage::unknown);
}

TEST_CASE("StageSplit: the valve is shut for a held q") {
  LoggedRows log = consolidated_rows();
  log.go(200, change_of(80, 0, 0, 0, -1000));
  log.go(200, change_of(0, -120, -60, 0, 0));
  const auto stages = log.stages();
  REQUIRE(stages.size() == 5);
  CHECK(stages[3].drainage == Drainage::open);
  CHECK(stages[3].control == AxialControl::unknown);
  CHECK(stages[4].drainage == Drainage::closed);
  CHECK(stages[4].control == AxialControl::constant_q);
  CHECK(stages[4].line == Approx(400).margin(4));
}

TEST_CASE("StageSplit: q is held while the pore pressure is raised, then lost") {
  LoggedRows log = consolidated_rows();
  log.go(200, change_of(80, 0, 0, 0, -1000));
  log.go(200, change_of(0, 0, 100, 100, 2000));
  log.go(10, change_of(-70, 0, 0, 0, 0));
  const auto stages = log.stages();
  REQUIRE(stages.size() == 5);
  CHECK(stages[4].control == AxialControl::constant_q);
  CHECK(stages[4].drainage == Drainage::open);
  CHECK(stages[4].line == Approx(400).margin(6));
}

TEST_CASE("StageSplit: a peak of q at a constant cell pressure is no held q") {
  LoggedRows log = consolidated_rows();
  log.go(100, change_of(80, 0, 60, 0, 0));
  log.go(100, change_of(0, 0, 40, 0, 0));
  log.go(100, change_of(-40, 0, 20, 0, 0));
  CHECK(log.stages().back().control == AxialControl::unknown);
}

TEST_CASE("StageSplit: a peak of q along a strain path is no held q") {
  LoggedRows log = consolidated_rows();
  log.go(100, change_of(80, 0, 60, 60, 1000));
  log.go(20, change_of(0, 0, 12, 12, 200));
  log.go(100, change_of(-60, 0, 60, 60, 1000));
  CHECK(log.stages().back().control == AxialControl::unknown);
}

TEST_CASE("StageSplit: a fall that the drainage cannot follow does not shut the valve") {
  LoggedRows log = consolidated_rows();
  log.go(300, change_of(80, 0, 0, 0, -1000));
  log.go(5, change_of(-70, 0, 100, 0, 0));
  const auto stages = log.stages();
  CHECK(stages.back().drainage == Drainage::open);
  CHECK(stages.back().line < 210);
}

TEST_CASE("StageSplit: consolidation under a load ends with the cell pressure") {
  LoggedRows log;
  log.go(20, change_of(0, 30, 30, 0, 0));
  log.go(20, change_of(0, -30, -30, 0, 0));
  log.go(30, change_of(10, 0, 0, 0, -200));
  log.go(100, change_of(60, 180, 0, 0, -4000));
  log.go(300, change_of(100, 0, 130, 0, 0));
  const auto stages = log.stages();
  REQUIRE(stages.size() == 4);
  CHECK(stages[2].role == StageRole::consolidation);
  CHECK(stages[3].role == StageRole::shear);
  CHECK(stages[3].line == Approx(170).margin(4));
}

TEST_CASE("StageSplit: strength that was lost before the cell pressure was raised is shear") {
  LoggedRows log;
  log.cell = 400;
  log.go(100, change_of(80, 0, 0, 0, -1000));
  log.go(100, change_of(-60, 0, 0, 0, -500));
  log.go(100, change_of(0, 200, 0, 0, -1000));
  log.go(100, change_of(150, 0, 0, 0, -1000));
  for (const auto& stage : log.stages()) CHECK(stage.role == StageRole::shear);
}

TEST_CASE("StageSplit: without a volume the load alone is known") {
  LoggedRows log;
  log.volume = kMissing;
  log.go(100, change_of(0, 180, 0, 0, 0));
  log.go(300, change_of(120, 0, 130, 0, 0));
  const auto stages = log.stages();
  REQUIRE(stages.size() == 2);
  CHECK(stages[1].role == StageRole::shear);
  CHECK(stages[1].drainage == Drainage::unknown);
}

TEST_CASE("StageSplit: rows without dimensions or too few of them are one stage") {
  LoggedRows log = consolidated_rows();
  CHECK(log.split.stages({}).size() == 1);
  LoggedRows few;
  few.go(10, change_of(50, 0, 60, 0, 0));
  CHECK(few.stages().size() == 1);
  CHECK(few.stages()[0].role == StageRole::shear);
}

TEST_CASE("StageSplit: a long record is split at the same rows") {
  LoggedRows log;
  log.go(2000, change_of(0, 30, 30, 0, 0));
  log.go(2000, change_of(0, -30, -30, 0, 0));
  log.go(10000, change_of(0, 180, 0, 0, -4000));
  log.go(30000, change_of(120, 0, 130, 0, 0));
  const auto stages = log.stages();
  REQUIRE(stages.size() == 4);
  CHECK(stages[2].line == Approx(4000).margin(200));
  CHECK(stages[3].line == Approx(14000).margin(200));
}
