// SPDX-License-Identifier: GPL-3.0-or-later
// Onset of instability and loss of control of whole tests, against what the specimen itself knows.
#include <catch2/catch.hpp>
#include <string>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

using namespace triax::lab;

namespace {

TestSummary simulated_summary(const std::string& name) {
  VirtualRig rig(load_programme("samples/programmes/" + name + ".toml"), 1);
  return run_session(rig, {});
}

}  // namespace

TEST_CASE("run_session: a CSU test turns before its control is lost", "[rig]") {
  const TestSummary summary = simulated_summary("csu_26");
  const Collapse& c = summary.collapse;
  REQUIRE(c.onset);
  REQUIRE(c.loss_of_control);
  CHECK(c.onset->reading < c.loss_of_control->reading);
  REQUIRE(c.onset_detected_at);
  REQUIRE(c.loss_of_control_detected_at);
  CHECK(c.loss_of_control_detected_at->reading >= c.loss_of_control->reading);
  CHECK(c.loss_of_control->interval);
  REQUIRE(summary.truth);
  REQUIRE_FALSE(summary.truth->run_aways.empty());
  const RunAwayTruth& truth = summary.truth->run_aways.front();
  CHECK(*c.loss_of_control->time_s == Approx(truth.start_s).margin(60));
  REQUIRE(truth.q_pa);
  REQUIRE(truth.p_eff_pa);
  CHECK(*c.loss_of_control->q_pa == Approx(*truth.q_pa).epsilon(0.05));
}

TEST_CASE("run_session: an ICU test keeps its control until p' is zero", "[rig]") {
  const TestSummary summary = simulated_summary("icu_6");
  const Collapse& c = summary.collapse;
  REQUIRE(c.onset);
  REQUIRE(c.loss_of_control);
  CHECK(c.loss_of_control->reading > c.onset->reading + 300);
  CHECK(*c.loss_of_control->p_eff_pa < 0.01 * *summary.consolidation.p_eff_pa);
  CHECK_FALSE(simulated_summary("icu_dense").collapse.loss_of_control);
}

TEST_CASE("run_session: under a load both instants lie within two readings", "[rig]") {
  const TestSummary summary = simulated_summary("icu_42");
  const Collapse& c = summary.collapse;
  REQUIRE(c.onset);
  REQUIRE(c.loss_of_control);
  // Second-order work vanishes while the pore fluid is compressed, just before the peak of q.
  CHECK(c.loss_of_control->reading >= c.onset->reading);
  CHECK(c.loss_of_control->reading <= c.onset->reading + 2);
  REQUIRE_FALSE(summary.truth->run_aways.empty());
  CHECK(*c.loss_of_control->time_s == Approx(summary.truth->run_aways[0].start_s).margin(1));
  REQUIRE(c.onset->interval);
  CHECK(c.onset->interval->eta.holds(*summary.truth->q_pa / *summary.truth->p_eff_pa));
  CHECK(*c.onset->eta() <= *c.loss_of_control->eta());
}
