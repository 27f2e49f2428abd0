// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sweep/sweep_summary.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax;
using namespace triax::study;

namespace {

SweepMember stored(double eta, double true_eta) {
  SweepMember member;
  member.id = 1;
  member.judged = true;
  member.kind = lab::CollapseKind::flow;
  member.eta = eta;
  member.truly_lost = true;
  member.true_eta = true_eta;
  return member;
}

}  // namespace

TEST_CASE("members are counted by what became of them") {
  std::vector<SweepMember> members{stored(0.5, 0.5), stored(0.7, 0.6), stored(0.6, 0.6),
                                   stored(0.6, 0.6), SweepMember{},    SweepMember{}};
  members[1].truly_lost = false;  // a false alarm
  members[1].true_eta.reset();
  members[2].kind = lab::CollapseKind::none;  // missed
  members[2].eta.reset();
  members[3].judged = false;
  members[4].failure = "made to fail";
  const auto sum = summary_of(members);
  CHECK(sum.tests == 6);
  CHECK(sum.stored == 4);
  CHECK(sum.failed == 1);
  CHECK(sum.not_run == 1);
  CHECK(sum.judged == 3);
  CHECK(sum.detected == 2);
  CHECK(sum.truly_lost == 3);
  CHECK(sum.truly_lost_detected == 1);
  CHECK(sum.false_alarms == 1);
}

TEST_CASE("stress ratios are spread where they are known and finite") {
  auto infinite = stored(0.5, 0.5);
  infinite.eta = INFINITY;
  const auto sum = summary_of({stored(0.5, 0.52), stored(0.7, 0.68), infinite});
  CHECK(sum.eta->mean == Approx(0.6));
  CHECK(sum.eta->largest == 0.7);
  CHECK(sum.true_eta->mean == Approx(1.7 / 3));
  CHECK(sum.eta_error->smallest == Approx(-0.02));
  CHECK(sum.eta_error->largest == Approx(0.02));
  const auto nothing = summary_of({SweepMember{}});
  CHECK_FALSE(nothing.eta);
  CHECK_FALSE(nothing.eta_error);
}
