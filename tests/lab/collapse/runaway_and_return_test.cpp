// SPDX-License-Identifier: GPL-3.0-or-later
// Whether strength that a runaway took came back, and what is told where it did.
#include <catch2/catch.hpp>
#include <numbers>
#include <set>

#include "lab/collapse/loss_and_return.hpp"
#include "lab/collapse/monitor.hpp"
#include "tests/lab/measured/synthetic_path.hpp"

using namespace triax::lab;
using triax::lab::testing::SyntheticPath;

namespace {

StageInfo returning_stage(int number, AxialControl control, Drainage drainage = Drainage::closed,
                          StageRole role = StageRole::shear) {
  return {.number = number, .name = "s", .role = role, .drainage = drainage, .control = control};
}

/// States of an undrained specimen of which the load on the cap and the axial strain are given.
class LoadedSpecimen {
 public:
  explicit LoadedSpecimen(std::vector<StageInfo> stages) : monitor_(header(std::move(stages))) {}

  /// `readings` on to this load (as q on the first area) and strain.
  LoadedSpecimen& to(int stage, int readings, double load, double strain) {
    const double load0 = load_, strain0 = strain_;
    for (int i = 1; i <= readings; ++i) {
      load_ = load0 + (load - load0) * i / readings;
      strain_ = strain0 + (strain - strain0) * i / readings;
      State s;
      s.stage = stage;
      s.reading = reading_++;
      s.time_s = static_cast<double>(s.reading);
      s.strain = {strain_, -strain_ / 2};
      s.volumetric_strain = 0;
      s.q = load_ * (1 - strain_);
      s.p_eff = 300e3 - s.q / 3;
      s.pore_pressure = 300e3;
      s.effective_stress = {s.p_eff + 2 * s.q / 3, s.p_eff - s.q / 3};
      monitor_.watch(s);
    }
    return *this;
  }
  Collapse end() { return monitor_.finish(); }
  std::int64_t last() const { return reading_ - 1; }

 private:
  static RecordHeader header(std::vector<StageInfo> stages) {
    RecordHeader h;
    h.stages = std::move(stages);
    return h;
  }
  CollapseMonitor monitor_;
  std::int64_t reading_ = 0;
  double load_ = 0, strain_ = 0;
};

const Criterion& control_of(const Collapse& c) { return c.criteria.at(1); }

}  // namespace

TEST_CASE("a leap of the strain under a load is a runaway, whatever q does afterwards") {
  for (const double leap : {0.008, 0.04, 0.087}) {
    for (const double later : {1.3, 2.0}) {
      LoadedSpecimen test({returning_stage(1, AxialControl::load)});
      test.to(1, 200, 200e3, 2e-3);
      const std::int64_t onset = test.last();
      test.to(1, 1, 200.1e3, 2e-3 + leap).to(1, 400, later * 200e3, 4e-3 + leap);
      INFO(leap << ' ' << later);
      const Collapse c = test.end();
      CHECK(c.kind == CollapseKind::limited);
      REQUIRE(c.onset);
      CHECK(c.onset->reading == onset);
      CHECK(c.onset->interval);  // though the watch began anew
      REQUIRE(c.onset_detected_at);
      CHECK(c.onset_detected_at->reading == onset + 1);
      CHECK(*c.strength_lost == Approx(leap).epsilon(0.1));
      CHECK(control_of(c).found());
      CHECK_THAT(control_of(c).evidence, Catch::Contains("recovered to"));
    }
  }
}

TEST_CASE("strength that does not come back leaves a runaway a flow") {
  LoadedSpecimen stands({returning_stage(1, AxialControl::load)});
  stands.to(1, 200, 200e3, 2e-3).to(1, 1, 200e3, 0.09).to(1, 100, 200e3, 0.0901);
  CHECK(stands.end().kind == CollapseKind::flow);
  LoadedSpecimen again({returning_stage(1, AxialControl::load)});
  again.to(1, 200, 200e3, 2e-3).to(1, 1, 200e3, 0.04).to(1, 300, 260e3, 0.05);
  const std::int64_t second = again.last();
  again.to(1, 1, 30e3, 0.2).to(1, 20, 30e3, 0.2);
  const Collapse c = again.end();
  CHECK(c.kind == CollapseKind::flow);
  CHECK(c.onset->reading == second);
}

TEST_CASE("strength comes back in a later stage, too, but not as another specimen") {
  const auto kind = [](AxialControl ran_under, const StageInfo& between, double cell) {
    LoadedSpecimen test(
        {returning_stage(1, ran_under), between, returning_stage(3, AxialControl::displacement)});
    test.to(1, 200, 160e3, 2e-3).to(1, 1, 160e3, 0.09).to(1, 60, 160e3, 0.0901);
    test.to(2, 30, 160e3, 0.0902).to(3, 400, cell * 160e3, 0.13);
    return test.end().kind;
  };
  const StageInfo rest = returning_stage(2, AxialControl::load);
  for (const AxialControl control : {AxialControl::load, AxialControl::constant_q}) {
    CHECK(kind(control, rest, 2) == CollapseKind::limited);
    CHECK(kind(control, rest, 0.99) == CollapseKind::flow);
    CHECK(kind(control, returning_stage(2, AxialControl::load, Drainage::open), 2) ==
          CollapseKind::flow);
    CHECK(kind(control,
               returning_stage(2, AxialControl::load, Drainage::closed, StageRole::consolidation),
               2) == CollapseKind::flow);
  }
}

TEST_CASE("a spike of the load cell is no strength that came back; two readings are") {
  State before;
  before.q = 150e3;
  for (const int readings : {1, 2}) {
    LossAndReturn loss(before, 0.05, Drainage::closed);
    for (int i = 0; i < 60; ++i) {
      State after = before;
      after.q = i >= 50 && i < 50 + readings ? 170e3 : 40e3;
      loss.add(after);
    }
    CHECK(loss.came_back() == (readings == 2));
    CHECK(loss.lost() == Approx(1 - 40.0 / 150));
  }
}

TEST_CASE("strength is looked for where the specimen runs, not on the side of q that it left") {
  State before;
  before.q = 2e3;
  LossAndReturn cycle(before, -0.01, Drainage::closed), same(before, 0.01, Drainage::closed);
  for (int i = 1; i <= 60; ++i) {
    State after = before;
    after.q = 2e3 - 2e3 * i;
    cycle.add(after);
    same.add(after);
  }
  CHECK(cycle.came_back());
  CHECK_FALSE(same.came_back());
}

TEST_CASE("a leap with which the load was stepped up is told, and no collapse") {
  LoadedSpecimen test(
      {returning_stage(1, AxialControl::displacement), returning_stage(2, AxialControl::load)});
  test.to(1, 100, 300e3, 0.01).to(2, 1, 410e3, 0.13).to(2, 100, 411e3, 0.14);
  const Collapse c = test.end();
  CHECK_FALSE(control_of(c).found());
  CHECK(c.kind == CollapseKind::none);
  CHECK(control_of(c).reading == 99);
  CHECK_THAT(control_of(c).evidence, Catch::Contains("a step of the load"));
}

TEST_CASE("what a frame showed before a load let the specimen fall is the onset") {
  RecordHeader header;
  header.stages = {returning_stage(1, AxialControl::displacement),
                   returning_stage(2, AxialControl::load)};
  CollapseMonitor monitor(header);
  SyntheticPath path;
  State s;
  for (int i = 0; i < 850; ++i) {  // 600: the peak; until here 7 % of q is lost
    s = path.state(i);
    s.stage = 1;
    monitor.watch(s);
  }
  s.stage = 2;
  s.q *= 0.3;
  s.p_eff *= 0.3;
  s.strain = {0.15, -0.075};
  for (int i = 850; i < 900; ++i) {
    s.reading = i;
    s.time_s = i;
    monitor.watch(s);
  }
  const Collapse c = monitor.finish();
  CHECK(c.kind == CollapseKind::flow);
  REQUIRE(c.onset);
  CHECK(c.onset->reading < 605);
  CHECK(c.onset->reading > 595);
}

TEST_CASE("no two points of second-order work carry one reading where readings are missing") {
  for (int hole = 375; hole < 395; ++hole) {
    std::multiset<std::int64_t> readings;
    CollapseMonitor monitor(
        testing::undrained_header(),
        {{.second_order_work = [&](const SecondOrderWorkPoint& p) { readings.insert(p.reading); },
          .happened = {}}});
    SyntheticPath path;
    for (int i = 0; i < 400; ++i)
      if (i < hole || i >= hole + 5) monitor.watch(path.state(i));
    monitor.finish();
    INFO(hole);
    CHECK(readings.size() > 370);
    CHECK(std::set<std::int64_t>(readings.begin(), readings.end()).size() == readings.size());
  }
}

TEST_CASE("the peak is no spike that the end of the record hides") {
  for (const int spike : {598, 599}) {
    CollapseMonitor monitor(testing::undrained_header());
    SyntheticPath path;
    for (int i = 0; i < 600; ++i) {
      State s = path.state(i);
      if (i == spike) s.q = -500e3;
      monitor.watch(s);
    }
    CHECK(monitor.peak()->q_pa == Approx(140e3).epsilon(1e-3));
  }
  CollapseMonitor step(testing::undrained_header());  // two readings are no spike
  SyntheticPath path;
  for (int i = 0; i < 600; ++i) {
    State s = path.state(i);
    if (i >= 598) s.q = 500e3;
    step.watch(s);
  }
  CHECK(step.peak()->q_pa == Approx(500e3));
}

TEST_CASE("cycles of strain that liquefy are cyclic mobility, from the first r_u of 0.95 on") {
  RecordHeader header = testing::undrained_header();
  CollapseMonitor monitor(header);
  for (int i = 0; i < 80 * 12; ++i) {
    const double fade = std::exp(-i / 30.0), wave = std::sin(2 * std::numbers::pi * i / 80.0);
    State s;
    s.stage = 1;
    s.reading = i;
    s.time_s = i;
    s.strain = {3e-3 * wave, -1.5e-3 * wave};
    s.volumetric_strain = 0;
    s.p_eff = 100e3 * fade;
    s.q = 0.4 * s.p_eff * wave;
    s.effective_stress = {s.p_eff + 2 * s.q / 3, s.p_eff - s.q / 3};
    s.pore_pressure = 400e3 - s.effective_stress.radial;
    monitor.watch(s);
  }
  const Collapse c = monitor.finish();
  CHECK(c.kind == CollapseKind::cyclic_mobility);
  REQUIRE(monitor.cyclic());
  CHECK(monitor.cyclic()->cycles > 10);
  REQUIRE(monitor.cyclic()->liquefied);
  CHECK(c.onset->reading == monitor.cyclic()->liquefied->instant.reading);
}
