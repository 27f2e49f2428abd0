// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/criteria.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "lab/collapse/control_peak.hpp"
#include "lab/collapse/loss_of_control.hpp"
#include "lab/collapse/second_order_work.hpp"

using namespace triax::lab;

namespace {

PathPoint strained_point(int i, double q) {
  PathPoint p;
  p.reading = p.progress = i;
  p.q = q;
  p.p_eff = 100e3;
  p.axial_strain = 1e-4 * i;
  p.stress_variance = 1;
  p.window_readings = 14;
  return p;
}

}  // namespace

TEST_CASE("every row of the list has a name of its own, evidence and a criterion that works") {
  std::set<std::string_view> names;
  for (const CriterionRow& row : collapse_criteria()) {
    INFO(row.name);
    CHECK(names.insert(row.name).second);
    CHECK_FALSE(row.otherwise.empty());
    const auto criterion = row.make();
    REQUIRE(criterion);
    criterion->start_stage(nullptr);
    CHECK_FALSE(criterion->finding());
    CHECK(criterion_of(row, std::nullopt).evidence == row.otherwise);
  }
  // Names of the database and of JSON, which others read; the verdict relies on the first.
  CHECK(collapse_criteria()[0].name == "second_order_work");
  CHECK(dynamic_cast<SecondOrderWork*>(collapse_criteria()[0].make().get()));
  CHECK(names.contains("loss_of_control"));
  CHECK(names.contains("control_peak"));
}

TEST_CASE("all criteria of a test are fed, and each tells its own finding") {
  Criteria criteria;
  criteria.start_stage(nullptr);
  for (int i = 0; i < 40; ++i)
    criteria.add_point(strained_point(i, i < 20 ? 3e3 * i : 60e3 - 2e3 * (i - 20)), false);
  const auto all = criteria.criteria();
  REQUIRE(all.size() == collapse_criteria().size());
  for (std::size_t i = 0; i < all.size(); ++i) CHECK(all[i].name == collapse_criteria()[i].name);
  const auto peak = criteria.of<ControlPeak>().finding();
  REQUIRE(peak);
  CHECK(all[2].found());
  CHECK(all[2].reading == peak->instant.reading);
  CHECK(all[2].eta == peak->instant.eta());
  CHECK(all[2].evidence == peak->evidence);
  CHECK_FALSE(all[1].found());
  CHECK(all[1].evidence.starts_with("not applied"));  // no state came
}

TEST_CASE("a criterion that could not see anything says why") {
  const auto evidence = [](AxialControl control, std::size_t row) {
    const StageInfo stage{.number = 1, .role = StageRole::shear, .control = control};
    Criteria criteria;
    criteria.start_stage(&stage);
    for (int i = 0; i < 40; ++i) {
      State s;
      s.reading = i;
      s.time_s = i;
      s.q = 1e3 * i;
      s.p_eff = 100e3;
      s.strain.axial = 1e-4 * i;
      criteria.add_state(s, true);
      criteria.add_point(strained_point(i, s.q), true);
    }
    return criteria.criteria()[row].evidence;
  };
  CHECK(evidence(AxialControl::displacement, 1).starts_with("not applied: a displacement"));
  CHECK(evidence(AxialControl::load, 1) == collapse_criteria()[1].otherwise);
  CHECK(evidence(AxialControl::load, 2).starts_with("not applied: a load"));
  CHECK(evidence(AxialControl::displacement, 2) == collapse_criteria()[2].otherwise);
}

TEST_CASE("a criterion that looked at something and saw no collapse says both") {
  const Finding dip{.instant = {.reading = 7}, .evidence = "a dip", .detected = false};
  const Criterion c = criterion_of(collapse_criteria()[0], dip);
  CHECK_FALSE(c.found());
  CHECK(c.reading == 7);
  CHECK(c.evidence == "a dip");
}

TEST_CASE("where nothing can be judged every criterion gives the reason") {
  const auto all = no_criteria("too short");
  REQUIRE(all.size() == collapse_criteria().size());
  for (const Criterion& c : all) {
    CHECK_FALSE(c.detected);  // neither yes nor no
    CHECK(c.evidence == "too short");
  }
}
