// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/warning_levels.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/warning/loose_path.hpp"

using namespace triax::lab;
using triax::lab::testing::LoosePath;
using triax::lab::testing::shear_header;

namespace {

WarningLevels started(AxialControl control) {
  WarningLevels levels(true);
  const RecordHeader header = shear_header(control);
  levels.start_stage(header.stage(1));
  return levels;
}

WarningLevel after(WarningLevels& levels, const State& state) {
  levels.add(state);
  levels.look(std::nullopt);
  return levels.level();
}

/// Undrained, on its way to phase transformation at η = 0.7, where p′ has its least; on the way
/// there −dq/dp′ comes down to 0.72 (normalised work 0.32), and q grows on.
State dense(double eta, int reading) {
  State s;
  s.reading = reading;
  s.time_s = reading;
  s.stage = 1;
  s.p_eff = 1e5 * (1 - 1.2 * eta + 0.85 * eta * eta);
  s.q = eta * s.p_eff;
  s.volumetric_strain = 0;
  s.strain = {0.002 * eta / (1 - 0.95 * eta), 0};
  s.pore_pressure = 4e5 - s.p_eff + s.q / 3;
  return s;
}

}  // namespace

TEST_CASE("among few readings one look is enough where the next may come after the fall") {
  WarningLevels levels = started(AxialControl::load);
  LoosePath path{.interval_s = 60};
  constexpr int kReadings = 12;
  for (int i = 1; i < kReadings; ++i)
    CHECK(after(levels, path.at(path.eta_under_load(0.99 * i / kReadings), i)) !=
          WarningLevel::imminent);
  CHECK(after(levels, path.at(path.eta_under_load(0.99), kReadings)) == WarningLevel::imminent);
}

TEST_CASE("dense sand is never imminent, however soft it has become") {
  WarningLevels levels = started(AxialControl::load);
  for (int i = 1; i <= 1000; ++i)
    CHECK(after(levels, dense(0.001 * i, i)) != WarningLevel::imminent);
  CHECK(levels.level() == WarningLevel::none);
}

TEST_CASE("a level is lost once, and never left within its stage") {
  WarningLevels levels = started(AxialControl::load);
  LoosePath path;
  for (int i = 1; i <= 100; ++i) after(levels, path.at(0.005 * i, i));
  CHECK(levels.lose());
  CHECK_FALSE(levels.lose());
  CHECK_FALSE(levels.look(false));
  CHECK(levels.level() == WarningLevel::lost);
  const RecordHeader header = shear_header(AxialControl::load);
  levels.start_stage(header.stage(1));
  CHECK(levels.level() == WarningLevel::none);
}
