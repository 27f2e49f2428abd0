// SPDX-License-Identifier: GPL-3.0-or-later
// Pauses and the safe state: the rig stands, the stage's time with it, and the path goes on where
// it was.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/lab/rig/rig_text.hpp"

using namespace triax::lab;
using namespace triax::lab::test;
using Catch::Contains;

namespace {

/// A compression that ends by time, so that a pause that counted would show.
std::string timed_compression(const std::string& drainage) {
  return shear_stage(drainage, "displacement", "axial_rate_mm_per_min = 0.5",
                     R"("time_min", above = 2.0)");
}
const std::string kLoad =
    shear_stage("closed", "load", "load_rate_N_per_min = 30.0", R"("time_min", above = 2.0)");
const std::string kPause =
    "[[operator]]\naction = \"hold\"\nat_min = 1.0\n[[operator]]\naction = \"resume\"\nat_min = "
    "1.5\n";

/// Every reading of the first stage is that of the test without a pause, 30 s later after it.
void same_without_pause(const std::string& stage) {
  VirtualRig paused(rig_programme(stage + kPause)), plain(rig_programme(stage));
  const auto with = all_readings(paused), without = all_readings(plain);
  const auto run = of_stage(with, 1), held = of_stage(with, 2);
  CHECK(held.size() == 120);
  CHECK(with.size() == without.size() + 120);
  REQUIRE(run.size() == without.size());
  for (std::size_t i = 0; i < run.size(); ++i)
    for (const Quantity q : plain.header().columns)
      REQUIRE(run[i][q] == Approx(without[i][q]).epsilon(1e-9).margin(1e-9));
  CHECK(run.back().time_s == Approx(without.back().time_s + 30));
}

}  // namespace

TEST_CASE("an ideal rig goes on after a pause as if there had been none") {
  same_without_pause(timed_compression("closed"));
  same_without_pause(timed_compression("open"));
  same_without_pause(kLoad);
}

TEST_CASE("while held the crosshead is locked, the pressures stay, and the header says so") {
  VirtualRig rig(rig_programme(timed_compression("closed") + kPause));
  const auto readings = all_readings(rig);
  const auto held = of_stage(readings, 2);
  REQUIRE(held.size() == 120);
  REQUIRE(rig.header().stages.size() == 2);
  CHECK(rig.header().stage(2)->role == StageRole::hold);
  CHECK_FALSE(rig.header().stage(2)->name.empty());
  for (const Reading& r : held)
    for (const Quantity q : rig.header().columns)
      CHECK(r[q] == Approx(held.front()[q]).epsilon(1e-12).margin(1e-15));
  CHECK(rig.header().warnings.empty());
  std::vector<EventKind> kinds;
  for (const Event& event : rig.events()) kinds.push_back(event.kind);
  CHECK(kinds == std::vector{EventKind::held, EventKind::resumed});
}

TEST_CASE("hold and resume from outside do what the operator's do") {
  VirtualRig rig(rig_programme(timed_compression("closed")));
  Reading r;
  while (rig.next(r) && r.time_s < 60) {
  }
  const double stood = r[Quantity::axial_displacement];
  rig.hold();
  for (int i = 0; i < 40; ++i) {
    REQUIRE(rig.next(r));
    CHECK(r.stage == 2);
    CHECK(r[Quantity::axial_displacement] == Approx(stood).epsilon(1e-12));
  }
  rig.resume();
  REQUIRE(rig.next(r));
  CHECK(r.stage == 1);
  CHECK(r[Quantity::axial_displacement] == Approx(stood + 0.25 * 0.5e-3 / 60).epsilon(1e-9));
  double last = 0;
  while (rig.next(r)) last = r.time_s;
  CHECK(last == Approx(130));
}

TEST_CASE("who asked for it stands in the event, and what changes nothing says so") {
  VirtualRig rig(rig_programme(timed_compression("closed")));
  Reading r;
  REQUIRE(rig.next(r));
  CHECK_FALSE(rig.resume("by Anna"));
  CHECK(rig.hold("by Anna"));
  CHECK_FALSE(rig.hold("by Ben"));
  CHECK(rig.resume("by Ben"));
  CHECK(rig.stop_safely("by Carla"));
  CHECK_FALSE(rig.resume("by Ben"));
  int after = 0;
  while (rig.next(r)) ++after;
  CHECK(after == VirtualRig::kSafeReadings);
  const auto events = rig.events();
  REQUIRE(events.size() == 3);
  CHECK(events[0].detail == "by Anna");
  CHECK(events[1].detail == "by Ben");
  CHECK(events[2].kind == EventKind::aborted);
  CHECK(events[2].detail == "by Carla");
}

TEST_CASE("abort: ten more readings in the safe state, and why") {
  VirtualRig by_call(rig_programme(timed_compression("closed")));
  Reading r;
  while (by_call.next(r) && r.time_s < 30) {
  }
  by_call.abort("somebody smelled smoke");
  by_call.resume();  // the safe state is for good
  int after = 0;
  while (by_call.next(r)) {
    CHECK(r.stage == 2);
    ++after;
  }
  CHECK(after == VirtualRig::kSafeReadings);
  REQUIRE(by_call.header().warnings.size() == 1);
  CHECK_THAT(by_call.header().warnings[0].text, Contains("somebody smelled smoke"));

  VirtualRig by_operator(rig_programme(timed_compression("closed") +
                                       "[[operator]]\naction = \"abort\"\nat_min = 0.5\n"));
  const auto readings = all_readings(by_operator);
  CHECK(of_stage(readings, 2).size() == VirtualRig::kSafeReadings);
  CHECK(readings.back().time_s == Approx(30 + VirtualRig::kSafeReadings * 0.25).margin(0.26));
  CHECK_THAT(by_operator.header().warnings.at(0).text, Contains("aborted by the operator"));
  // It earns no verdict of none.
  CHECK_THAT(by_operator.header().cut_short, Contains("aborted by the operator"));
}
