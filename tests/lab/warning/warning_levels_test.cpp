// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/warning_levels.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/lab/warning/loose_path.hpp"

using namespace triax::lab;
using triax::lab::testing::LoosePath;
using triax::lab::testing::shear_header;

namespace {

WarningLevels levels_started(AxialControl control) {
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
  WarningLevels levels = levels_started(AxialControl::load);
  LoosePath path{.interval_s = 60};
  constexpr int kReadings = 12;
  for (int i = 1; i < kReadings; ++i)
    CHECK(after(levels, path.at(path.eta_under_load(0.99 * i / kReadings), i)) !=
          WarningLevel::imminent);
  CHECK(after(levels, path.at(path.eta_under_load(0.99), kReadings)) == WarningLevel::imminent);
}

TEST_CASE("dense sand is never imminent, however soft it has become") {
  WarningLevels levels = levels_started(AxialControl::load);
  for (int i = 1; i <= 1000; ++i)
    CHECK(after(levels, dense(0.001 * i, i)) != WarningLevel::imminent);
  CHECK(levels.level() == WarningLevel::none);
}

TEST_CASE("a level is lost once, and never left within its stage") {
  WarningLevels levels = levels_started(AxialControl::load);
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

TEST_CASE("near the limit surface less work is called low") {
  // The path collapses at η = 0.6: with a limit at 0.63 it is close below it all the way.
  const auto first = [](double limit) {
    WarningLevels levels = levels_started(AxialControl::load);
    LoosePath path;
    for (int i = 1; i < 600; ++i) {
      levels.add(path.at(0.001 * i, i));
      levels.look(true, std::max(1 - 0.6 / limit, 0.0));
      if (levels.level() == WarningLevel::imminent) return 0.001 * i;
    }
    return 1.0;
  };
  CHECK(first(1.29) < 0.5);
  CHECK(first(1.29) == first(5));
  CHECK(first(0.7) > first(1.29) + 0.02);
  CHECK(first(0.63) > first(0.7));
  CHECK(first(0.63) < 0.6);
  CHECK(first(0.6) == 1.0);  // on the limit itself
}

TEST_CASE("a work with which earlier tests of the sand carried on is no sign") {
  const auto level_at = [](double min_work) {
    EarlierTests earlier;
    earlier.add(
        {.name = "sound", .control = DrivenPath::Control::strain_path, .min_work = min_work});
    WarningLevels levels(true, earlier);
    const RecordHeader header = shear_header(AxialControl::load);
    levels.start_stage(header.stage(1));
    LoosePath path;
    for (int i = 1; i <= 560; ++i) after(levels, path.at(0.001 * i, i));
    return levels.level();
  };
  // At η = 0.56 r = 0.08 and the work is 0.038.
  CHECK(level_at(0.3) == WarningLevel::imminent);
  CHECK(level_at(0.01) == WarningLevel::none);
}

namespace {

/// Of a specimen as stiff as ever, whose next scan may reach where two earlier ones lost it.
WarningLevel stiff_near_earlier(bool one_carried_on) {
  const EarlierTest lost{.name = "lost",
                         .control = DrivenPath::Control::strain_path,
                         .onset = 0.6,
                         .onset_error = 0.001};
  EarlierTests earlier;
  for (int i = 0; i < 2; ++i) earlier.add(lost);
  if (one_carried_on) earlier.add({.name = "sound", .control = lost.control, .min_work = 0.001});
  WarningLevels levels(true, earlier);
  const RecordHeader header = shear_header(AxialControl::load);
  levels.start_stage(header.stage(1));
  LoosePath path{.eta_onset = 5};
  int reading = 0;
  for (; reading <= 4; ++reading)
    CHECK(after(levels, path.at(0.1 * reading + 0.01, reading)) == WarningLevel::none);
  after(levels, path.at(0.51, 5));
  return after(levels, path.at(0.57, 6));
}

}  // namespace

TEST_CASE("what earlier tests agree on is imminent within the next scans, however stiff it looks") {
  CHECK(stiff_near_earlier(false) == WarningLevel::imminent);
  CHECK(stiff_near_earlier(true) == WarningLevel::none);
}

TEST_CASE("WarningLevels: a root far behind the present state is no forecast") {
  // At held q the fit's root is at η = 0.6; the specimen is controlled at 0.85.
  WarningLevels levels = levels_started(AxialControl::constant_q);
  State s;
  s.stage = 1;
  s.q = 9e4;
  for (int i = 0; i <= 640; ++i) {
    s.reading = i;
    s.time_s = i;
    s.p_eff = 3e5 - 300.0 * i;
    s.strain = {1e-8 * (3e5 - s.p_eff), 0};
    s.pore_pressure = 5e5 + 2 * (s.p_eff - 3e5) - s.q / 0.3 * std::log(s.p_eff / 3e5);
    after(levels, s);
    if (s.eta() > 0.5 && s.eta() < 0.59) CHECK(levels.current_forecast(s));
    if (s.eta() > 0.85) CHECK_FALSE(levels.current_forecast(s));
  }
}
