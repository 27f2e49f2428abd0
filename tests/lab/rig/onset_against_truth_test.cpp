// SPDX-License-Identifier: GPL-3.0-or-later
// The monitor, which sees noisy readings only, against the virtual specimen's own loss of
// sustainability.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

using namespace triax::lab;

namespace {

TestSummary run_with_seed(const std::string& programme, std::uint64_t seed) {
  VirtualRig rig(load_programme("samples/programmes/" + programme + ".toml"), seed);
  return run_session(rig, {});
}

}  // namespace

TEST_CASE(
    "ICU, CSD and CSU: the stress ratio at onset is the specimen's own within 0.02, any noise",
    "[slow]") {
  for (const char* programme : {"icu_6", "icu_42", "csd_51", "csd_58", "csd_60", "csu_26", "csu_27",
                                "csu_31", "csu_41", "icu_7", "csd_61"}) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const TestSummary s = run_with_seed(programme, seed);
      INFO(programme << ", seed " << seed);
      REQUIRE(s.truth);
      REQUIRE(s.truth->lost_sustainability);
      REQUIRE(s.collapse.kind == CollapseKind::flow);
      CHECK(s.collapse.inside_limit_surface == true);
      const double truth = *s.truth->q_pa / *s.truth->p_eff_pa;
      CHECK(std::fabs(*s.collapse.onset->eta() - truth) < 0.02);
    }
  }
}

TEST_CASE(
    "a blow under dead load past the peak of q: the fall is seen, its onset is that of the peak") {
  const TestSummary s = run_with_seed("perturbed", 1);
  REQUIRE(s.truth->run_aways.size() == 2);
  const RunAwayTruth& fall = s.truth->run_aways[1];
  const auto lost = std::ranges::find(s.collapse.criteria, "loss_of_control", &Criterion::name);
  REQUIRE(lost != s.collapse.criteria.end());
  // At the last reading before it, which belongs to the stage before.
  CHECK(lost->found());
  REQUIRE(lost->time_s);
  CHECK(*lost->time_s <= fall.start_s);
  CHECK(*lost->time_s > fall.start_s - 0.5);
  const double truth = *s.truth->q_pa / *s.truth->p_eff_pa;
  CHECK(std::fabs(*s.collapse.onset->eta() - truth) < 0.02);
  // An eighth of q was lost by displacement, and the rest in the fall.
  CHECK(s.collapse.kind == CollapseKind::flow);
  CHECK(*s.collapse.strength_lost > 0.9);
}

TEST_CASE("dense sand is a control: it must not collapse, whatever the noise") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const TestSummary s = run_with_seed("icu_dense", seed);
    CHECK_FALSE(s.truth->lost_sustainability);
    CHECK(s.collapse.kind == CollapseKind::none);
    CHECK(s.collapse.judged);
  }
}
