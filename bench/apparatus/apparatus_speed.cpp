// SPDX-License-Identifier: GPL-3.0-or-later
// bench_apparatus_speed: simulated seconds per wall second of a programme at 10 readings a second,
// for the rig alone, with reduction and monitor, and with the database behind them.
//
// The yardstick is the bare material point: the strain increments that the specimen made between
// readings, each one call of sim::advance_point from the state in which the specimen was. All in
// one process and thread (the recorder has a second one for the disk).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <utility>

#include "bench/point/yardstick.hpp"
#include "db/recording/recorder.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

using namespace triax;

namespace {

constexpr double kInterval_s = 0.1;
constexpr int kRepetitions = 7;

/// Every stage read as densely as all others, whatever its own interval.
lab::Programme programme_of(const std::string& file) {
  auto programme = lab::read_programme(lab::read_text_file(file), file);
  programme.logging = {.interval_s = kInterval_s, .averaging_s = 0};
  for (lab::Stage& stage : programme.stages) stage.logging = programme.logging;
  return programme;
}

struct Increment {
  sim::PointState<sim::Axisymmetric> from;
  sim::MixedControl<sim::Axisymmetric> control;
};

/// What the material point inside the specimen did between readings: natural strains, as the
/// specimen takes them.
std::vector<Increment> increments_of(const lab::Programme& programme) {
  lab::VirtualRig rig(programme);
  std::vector<Increment> increments;
  lab::Reading reading;
  rig.next(reading);
  for (auto before = rig.specimen_state(); rig.next(reading); before = rig.specimen_state()) {
    const auto& after = rig.specimen_state();
    const double axial = std::log(before.height_m / after.height_m);
    const double volumetric =
        std::log((1 + before.material.void_ratio) / (1 + after.material.void_ratio));
    const auto strain = sim::components(sim::AxisymmetricStrain{axial, (volumetric - axial) / 2});
    increments.push_back({before.material, sim::MixedControl<sim::Axisymmetric>::strains(strain)});
  }
  return increments;
}

double drive_point(const lab::Programme& programme, const std::vector<Increment>& increments) {
  const auto& law = *programme.material.material.axisymmetric;
  double sink = 0;
  for (const Increment& i : increments)
    sink += sim::advance_point(law, i.from, i.control).state.stress[0];
  return sink;
}

std::int64_t run_rig(const lab::Programme& programme) {
  lab::VirtualRig rig(programme);
  lab::Reading reading;
  std::int64_t readings = 0;
  while (rig.next(reading)) ++readings;
  return readings;
}

void run_monitored(const lab::Programme& programme) {
  lab::VirtualRig rig(programme);
  static_cast<void>(lab::run_session(rig, {}));
}

void run_stored(const lab::Programme& programme, const std::string& db) {
  lab::VirtualRig rig(programme);
  db::Recorder recorder(db);
  recorder.finish(lab::run_session(rig, {}, {recorder.listener()}));
}

}  // namespace

int main(int argc, char** argv) {
  bench::take_labels(argc, argv);
  const std::string file = argc > 1 ? argv[1] : "samples/programmes/csu_26.toml";
  const std::string db = argc > 2 ? argv[2] : "bench_apparatus_speed.db";
  const lab::Programme programme = programme_of(file);
  const auto increments = increments_of(programme);
  const double simulated_s = static_cast<double>(run_rig(programme) - 1) * kInterval_s;
  fmt::print("{}: {:.0f} s of test, {} increments between readings\n\n", programme.name,
             simulated_s, increments.size());
  fmt::print("{:<36}{:>9}{:>20}{:>17}\n", "", "seconds", "simulated a second", "times the point");
  double sink = 0;
  const std::pair<const char*, std::function<void()>> subjects[] = {
      {"material point alone", [&] { sink = drive_point(programme, increments); }},
      {"rig", [&] { run_rig(programme); }},
      {"rig, reduction and monitor", [&] { run_monitored(programme); }},
      {"the same into the database", [&] { run_stored(programme, db); }}};
  double least_s[std::size(subjects)];
  std::fill(std::begin(least_s), std::end(least_s), std::numeric_limits<double>::infinity());
  // In turn, so that what else runs on the machine falls on all alike.
  for (int i = 0; i < (bench::only_labels ? 1 : kRepetitions); ++i)
    for (std::size_t k = 0; k < std::size(subjects); ++k)
      least_s[k] = std::min(least_s[k], bench::least_seconds(1, subjects[k].second));
  for (std::size_t k = 0; k < std::size(subjects); ++k)
    fmt::print("{:<36}{:>9}{:>20}{:>17}\n", subjects[k].first, bench::timed(least_s[k], 2),
               bench::timed(simulated_s / least_s[k], 0), bench::timed(least_s[k] / least_s[0], 1));
  volatile double kept = sink;
  static_cast<void>(kept);
}
