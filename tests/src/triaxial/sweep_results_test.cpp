// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sweep_results.hpp"

#include <catch2/catch.hpp>

#include "tests/src/study/sweep/sweep_programme.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::study;
using Catch::Contains;

namespace {

SweepMember collapsed(std::int64_t place, double eta, double true_eta) {
  SweepMember m;
  m.place = place;
  m.id = place;
  m.judged = true;
  m.kind = lab::CollapseKind::flow;
  m.eta = eta;
  m.time_s = 100;
  m.truly_lost = true;
  m.true_eta = true_eta;
  m.true_time_s = 99;
  return m;
}

}  // namespace

TEST_CASE("the summary counts and spreads what was found against the truth") {
  const auto sweep = src::test::sweep_of({"seed=1:6:1"});
  std::vector<SweepMember> members{collapsed(1, 0.5, 0.51), collapsed(2, 0.7, 0.68),
                                   collapsed(3, 0.6, 0.6),  collapsed(4, 0.6, 0.6),
                                   SweepMember{},           SweepMember{}};
  members[3].truly_lost = false;  // a false alarm
  members[3].true_eta.reset();
  members[4] = {.place = 5, .id = 5, .failure = {}, .judged = true, .truly_lost = true};  // missed
  members[5] = {.place = 6, .id = {}, .failure = "made to fail"};
  const std::string text = sweep_text(sweep, members);
  CHECK_THAT(text, Contains("SIMULATED"));
  CHECK_THAT(text, Contains("6 tests, 1 failed, 5 assessed, 4 collapses detected"));
  CHECK_THAT(text, Contains("η at collapse: mean 0.6000, minimum 0.5000, maximum 0.7000, standard "
                            "deviation 0.0816"));
  CHECK_THAT(text, Contains("4 became unstable, 3 of them detected; 1 detected although stable"));
  CHECK_THAT(text, Contains("mean 0.0033, minimum -0.0100, maximum 0.0200"));
  const auto failures = sweep_failures(sweep, members);
  REQUIRE(failures.size() == 1);
  CHECK(failures[0] == "--sweep [seed 6]: made to fail");
}

TEST_CASE("a long sweep is cut short in the table and in its failures, not in the counts") {
  const auto sweep = src::test::sweep_of({"seed=1:1000:1"});
  std::vector<SweepMember> members;
  for (int i = 1; i <= 1000; ++i)
    members.push_back({.place = i, .id = {}, .failure = "line\nbreak"});
  const std::string text = sweep_text(sweep, members);
  CHECK_THAT(text, Contains("and 960 more") && Contains("1000 tests, 1000 failed"));
  CHECK(std::count(text.begin(), text.end(), '\n') < 60);
  const auto failures = sweep_failures(sweep, members);
  REQUIRE(failures.size() == 11);
  CHECK(failures[0] == "--sweep [seed 1]: line break");
  CHECK_THAT(failures[10], Contains("990 more"));
}
