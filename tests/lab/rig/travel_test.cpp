// SPDX-License-Identifier: GPL-3.0-or-later
// Both ends of the frame's travel: whatever moves the cap comes to a stop there, and what is told
// of it holds together.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "lab/records/record_writer.hpp"
#include "lab/rig/recorded.hpp"
#include "lab/rig/session.hpp"
#include "tests/lab/rig/rig_text.hpp"

using namespace triax::lab;
using Catch::Contains;

namespace {

constexpr double kTravel_m = 0.02;
const std::string kFrame = "[rig.frame]\ntravel_mm = 20.0\nmoving_mass_kg = 5.0\n";
const std::string kHour = "\"time_min\", above = 60.0";

Programme travelling(const std::string& stages) {
  return test::rig_programme(stages, kFrame, 1, "sanisand/S28-general");
}

/// To q = ±30 kPa by load, and then dead load with so much more put on at once.
std::string step_after_load(int way, const std::string& drainage) {
  const std::string sign = way > 0 ? "" : "-", end = way > 0 ? "above = " : "below = -";
  return test::shear_stage(drainage, "load", "load_rate_N_per_min = " + sign + "30.0",
                           "\"q_kPa\", " + end + "30.0") +
         test::shear_stage(drainage, "dead_load", "load_step_N = " + sign + "200.0", kHour);
}

struct Way {
  std::string what, stages;
};

std::vector<Way> ways(int way) {
  const std::string sign = way > 0 ? "" : "-";
  const auto moved = [&](const std::string& axial, const std::string& drainage,
                         const std::string& keys) {
    return test::shear_stage(drainage, axial, keys, kHour);
  };
  return {{"crosshead", moved("displacement", "open", "axial_rate_mm_per_min = " + sign + "5.0")},
          {"crosshead, undrained",
           moved("displacement", "closed", "axial_rate_mm_per_min = " + sign + "5.0")},
          {"spring",
           moved("spring", "closed",
                 "spring_stiffness_N_per_mm = 200.0\naxial_rate_mm_per_min = " + sign + "5.0")},
          {"load", moved("load", "closed", "load_rate_N_per_min = " + sign + "30.0")},
          {"load, drained", moved("load", "open", "load_rate_N_per_min = " + sign + "60.0")},
          {"masses", step_after_load(way, "closed")}};
}

double displacement(const Reading& reading) { return reading[Quantity::axial_displacement]; }

}  // namespace

TEST_CASE("the travel ends in extension as in compression, whatever moves the cap") {
  const int way = GENERATE(1, -1);
  for (const Way& driven : ways(way)) {
    INFO(driven.what << (way > 0 ? ", compression" : ", extension"));
    VirtualRig rig(travelling(driven.stages));
    const auto readings = test::all_readings(rig);
    for (const Reading& reading : readings)
      CHECK(std::fabs(displacement(reading)) <= kTravel_m * (1 + 1e-9));
    CHECK(way * displacement(readings.back()) > 0.98 * kTravel_m);
    CHECK(readings.back().time_s < 3000);
    REQUIRE_FALSE(rig.header().warnings.empty());
    const std::string told = rig.header().warnings.back().text;
    CHECK_THAT(told, Contains("travel limit of 20 mm reached"));
    CHECK((told.find("in extension") != std::string::npos) == (way < 0));
  }
}

TEST_CASE("a cap that fell is no specimen that stayed sustainable; its record replays to the bit") {
  // Drained compression hardens, on an area that grows: there is no fall.
  const auto [way, drainage] = GENERATE(table<int, std::string>(
      {std::tuple(1, "closed"), std::tuple(-1, "closed"), std::tuple(-1, "open")}));
  const std::string rate = way > 0 ? "60.0" : "-60.0";
  const Programme programme =
      travelling(test::shear_stage(drainage, "load", "load_rate_N_per_min = " + rate, kHour));
  INFO(drainage << (way > 0 ? ", compression" : ", extension"));
  VirtualRig rig(programme);
  const auto path = (std::filesystem::temp_directory_path() / "triax_travel.csv").string();
  RecordWriter writer(path, rig.header());
  for (Reading reading; rig.next(reading);) writer.write(reading);
  writer.finish(rig.header(), rig.truth());

  const Truth truth = *rig.truth();
  REQUIRE_FALSE(truth.run_aways.empty());
  const RunAwayTruth& fall = truth.run_aways.back();
  CHECK(fall.end == RunAwayEnd::end_of_travel);
  REQUIRE(truth.lost_sustainability);
  CHECK(*truth.time_s <= fall.start_s + 0.5);
  CHECK(std::fabs(*truth.axial_strain) < 0.15);

  VirtualRig again(programme);
  const TestSummary seen = run_session(again, {});
  const TestSummary replayed = run_session(*open_record(path, {}), {});
  std::filesystem::remove(path);
  CHECK(replayed.readings == seen.readings);
  CHECK(replayed.collapse.kind == seen.collapse.kind);
  CHECK(replayed.collapse.onset.has_value() == seen.collapse.onset.has_value());
  REQUIRE(seen.collapse.detected());
  CHECK(*replayed.collapse.onset->time_s == *seen.collapse.onset->time_s);
  CHECK(*seen.collapse.onset->time_s == Approx(*truth.time_s).margin(5));
}

TEST_CASE(
    "a crosshead that comes to the end of its travel is no fall, through a frame that gives too") {
  const std::string rate = GENERATE("3.0", "-3.0");
  const std::string frame = GENERATE("", "stiffness_kN_per_mm = 50.0\n");
  INFO(rate << ' ' << frame);
  VirtualRig rig(test::rig_programme(
      test::shear_stage("open", "displacement", "axial_rate_mm_per_min = " + rate, kHour),
      kFrame + frame, 1, "sanisand/S28-general"));
  const TestSummary seen = run_session(rig, {});
  CHECK(rig.header().cut_short.empty());
  CHECK_FALSE(seen.truth->lost_sustainability);
  CHECK(seen.collapse.judged);
  CHECK(seen.collapse.kind == CollapseKind::none);
}

TEST_CASE(
    "a fall in extension on the limit surface is a failure, and not a test that stayed whole") {
  VirtualRig rig(read_programme(R"(
test = {name = "b", type = "CSD", scan_interval_s = 2.5}
specimen = {material = "sanisand/Toyoura-DM04", height_mm = 100, diameter_mm = 50, void_ratio = 0.9, initial_effective_stress_kPa = 100}
rig = {back_pressure_kPa = 200}
)" + test::shear_stage("open", "load", "load_rate_N_per_min = -30.0", kHour),
                                "p.toml"));
  const TestSummary seen = run_session(rig, {});
  CHECK(seen.truth->lost_sustainability);
  CHECK(seen.truth->run_aways.back().end == RunAwayEnd::end_of_travel);
  CHECK(seen.collapse.kind == CollapseKind::none);
  CHECK(seen.collapse.inside_limit_surface == false);
  REQUIRE(seen.collapse.onset);
  CHECK(*seen.collapse.onset->time_s == Approx(*seen.truth->time_s).margin(2.5));
}
