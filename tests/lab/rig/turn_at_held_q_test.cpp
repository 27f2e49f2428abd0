// SPDX-License-Identifier: GPL-3.0-or-later
// At held q the turn of the volume, or of the pore pressure, is reported before the fall.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

using namespace triax::lab;

namespace {

struct HeldQTest {
  std::vector<Event> events;
  Collapse collapse;
  const Event* first(EventKind kind) const {
    const auto found = std::ranges::find(events, kind, &Event::kind);
    return found == events.end() ? nullptr : &*found;
  }
};

HeldQTest run(const std::string& programme) {
  HeldQTest test;
  VirtualRig rig(load_programme("samples/programmes/" + programme + ".toml"));
  SessionListener listener;
  listener.happened = [&](const Event& e) { test.events.push_back(e); };
  test.collapse = run_session(rig, {}, {listener}).collapse;
  return test;
}

}  // namespace

TEST_CASE("run_session: at held q the onset is reported before the fall") {
  const HeldQTest test = run("csu_26");
  const Event* onset = test.first(EventKind::loss_of_sustainability);
  const Event* fall = test.first(EventKind::lost);
  const Event* imminent = test.first(EventKind::imminent);
  REQUIRE(onset);
  REQUIRE(fall);
  REQUIRE(imminent);
  CHECK(onset->detected_at->reading < fall->detected_at->reading);
  CHECK(imminent->detected_at->reading < fall->detected_at->reading);
  CHECK(test.collapse.onset_detected_at->reading == onset->detected_at->reading);
  CHECK_FALSE(test.first(EventKind::warning_withdrawn));
}

TEST_CASE("run_session: at held q dense sand has no onset") {
  const HeldQTest test = run("control_csu_dense");
  CHECK_FALSE(test.first(EventKind::loss_of_sustainability));
  CHECK(test.collapse.judged);
  CHECK(test.collapse.kind == CollapseKind::none);
}
