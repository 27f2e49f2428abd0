// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/simulated/without_guard.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

using namespace triax::lab;
using Catch::Contains;

TEST_CASE("what a guard was good for: the same test with and without it") {
  Programme programme = load_programme("samples/programmes/icu_load.toml");
  CHECK_FALSE(without_guard(programme, {}));
  programme.guard = Guard{.rate_m_per_s = 0.05e-3 / 60, .further_strain = 0.005};
  VirtualRig rig(programme);
  std::vector<Event> events;
  const SessionListener listener{.happened = [&](const Event& e) { events.push_back(e); }};
  const TestSummary summary = run_session(
      rig, {.reduction = {}, .without_guard = without_guard(programme, {})}, {listener});
  REQUIRE(summary.guard);
  const GuardOutcome& guard = *summary.guard;
  CHECK(guard.level == WarningLevel::imminent);
  CHECK(*guard.last_axial_strain - *guard.at.axial_strain == Approx(0.005).margin(2e-4));
  REQUIRE(guard.second_order_work_normalised);
  CHECK(*guard.second_order_work_normalised > 0);
  // The warning stands although its stage ended with it.
  REQUIRE(summary.collapse.imminent);
  CHECK(summary.collapse.imminent->reading == guard.at.reading);
  const auto event = std::ranges::find(events, EventKind::guarded, &Event::kind);
  REQUIRE(event != events.end());
  CHECK(event->reading == guard.at.reading);
  CHECK(event->detected_at->reading == guard.at.reading);
  CHECK_THAT(event->detail, Contains("on imminent: switched") && Contains("second-order work"));
  // 16.8 % is where the fall ends at the stop.
  REQUIRE(guard.without);
  CHECK(*guard.without->last_axial_strain > 0.15);
  CHECK(guard.without->kind == CollapseKind::flow);
  REQUIRE(guard.without->lost);
  CHECK(guard.without->lost->reading > guard.at.reading);
  CHECK(summary.truth->run_aways.empty());
}

TEST_CASE(
    "a fall is told at the second reading that shows it, and the collapse was known with it") {
  for (const char* name : {"icu_load", "csd_58", "csu_41"}) {
    INFO(name);
    VirtualRig rig(load_programme(std::string("samples/programmes/") + name + ".toml"));
    std::vector<double> times;
    std::vector<Event> lost;
    const SessionListener listener{
        .scanned = [&](const Reading& r, const State&) { times.push_back(r.time_s); },
        .happened =
            [&](const Event& e) {
              if (e.kind == EventKind::lost) lost.push_back(e);
            }};
    const TestSummary summary = run_session(rig, {}, {listener});
    REQUIRE(lost.size() == 1);
    const double fall_s = summary.truth->run_aways.back().start_s;
    const auto first = std::ranges::upper_bound(times, fall_s) - times.begin();
    // A reading that is the mean of what was before and after the fall shows little of it.
    CHECK(lost[0].detected_at->reading <= first + 2);
    CHECK(lost[0].detected_at->reading == lost[0].reading + 2);
    REQUIRE(summary.collapse.onset_detected_at);
    CHECK(summary.collapse.onset_detected_at->reading <= lost[0].detected_at->reading);
  }
}
