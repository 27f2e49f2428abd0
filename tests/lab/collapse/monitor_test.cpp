// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/monitor.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "tests/lab/measured/synthetic_path.hpp"

using namespace triax::lab;
using triax::lab::testing::SyntheticPath;
using triax::lab::testing::undrained_header;

namespace {

Collapse judge(SyntheticPath path, int readings, RecordHeader header = undrained_header()) {
  CollapseMonitor monitor(header);
  for (int i = 0; i < readings; ++i) monitor.watch(path.state(i));
  return monitor.finish();
}

}  // namespace

TEST_CASE("a clean peak is a flow collapse with its onset at the peak") {
  const Collapse c = judge({}, 5000);
  REQUIRE(c.kind == CollapseKind::flow);
  CHECK(std::abs(c.onset->reading - 600) <= 3);
  CHECK(*c.onset->q_pa == Approx(140e3).epsilon(1e-3));
  REQUIRE(c.criteria.size() == 3);
  CHECK(c.criteria[0].found());
  CHECK_FALSE(c.criteria[1].found());  // a prescribed displacement is never lost
  CHECK(c.criteria[2].found());
  CHECK(*c.second_order_work_normalised < 0);
}

TEST_CASE("CollapseMonitor: displacement is controlled until q is gone", "[collapse]") {
  CHECK_FALSE(judge({}, 5000).loss_of_control);  // a twentieth of q stays
  SyntheticPath path;
  path.residual = 0;
  const Collapse c = judge(path, 5000);
  REQUIRE(c.onset);
  CHECK(std::abs(c.onset->reading - 600) <= 3);
  REQUIRE(c.loss_of_control);
  const auto at = static_cast<double>(c.loss_of_control->reading);
  CHECK(path.q(at * path.strain_step) <= 0.01 * path.q_peak);
  CHECK(path.q((at - 2) * path.strain_step) > 0.01 * path.q_peak);
  REQUIRE(c.loss_of_control_detected_at);
  CHECK(c.loss_of_control_detected_at->reading == c.loss_of_control->reading + 2);
}

TEST_CASE("a peak that is over before the first window is full is the onset, not its middle") {
  SyntheticPath path;
  path.strain_step =
      0.004;  // the third reading is the largest, the middle of the window the fourth
  const Collapse c = judge(path, 30);
  REQUIRE(c.kind == CollapseKind::flow);
  CHECK(c.onset->reading == 2);
  CHECK(*c.onset->q_pa == Approx(path.q(0.008)));
  CHECK(c.criteria[0].reading.value() >= 3);
}

TEST_CASE("the onset of a noisy test has an interval that holds the peak, and a narrow one") {
  int q = 0, eta = 0;
  constexpr int kTimes = 20;
  for (int seed = 1; seed <= kTimes; ++seed) {
    SyntheticPath path;
    path.q_noise = path.u_noise = 400;
    path.rng.seed(static_cast<std::uint64_t>(seed));
    const Collapse c = judge(path, 5000);
    REQUIRE(c.onset);
    REQUIRE(c.onset->interval);
    const StressInterval& at = *c.onset->interval;
    q += at.q_pa.holds(path.q_peak);
    eta += at.eta.holds(path.q_peak / path.p(path.peak_strain));
    CHECK(at.eta.holds(*c.onset->eta()));
    CHECK(at.eta.high - at.eta.low < 0.15);
  }
  CHECK(q >= 17);
  CHECK(eta >= 17);
}

TEST_CASE("between few readings the interval is the gap that hides the peak") {
  SyntheticPath path;
  path.strain_step = 0.0011;  // the peak lies between the readings 5 and 6
  const Collapse c = judge(path, 60);
  REQUIRE(c.kind == CollapseKind::flow);
  REQUIRE(c.onset->interval);
  CHECK(c.onset->interval->eta.holds(path.q_peak / path.p(path.peak_strain)));
  CHECK(c.onset->interval->eta.high - c.onset->interval->eta.low > 0.01);
}

TEST_CASE("a collapse is known when a tenth of q is lost, at the reading taken by then") {
  SyntheticPath path;
  CollapseMonitor monitor(undrained_header());
  std::int64_t first = -1;
  for (int i = 0; i < 5000; ++i) {
    monitor.watch(path.state(i), Moment{i + 20, i + 20.0});
    if (first < 0 && i % 8 == 0 && monitor.so_far().detected()) first = i + 20;
  }
  const Collapse c = monitor.finish();
  REQUIRE(c.onset_detected_at);
  CHECK(std::abs(c.onset_detected_at->reading - first) <= 8);
  CHECK(c.onset_detected_at->time_s == static_cast<double>(c.onset_detected_at->reading));
  REQUIRE(c.criteria[0].detected_at);
  CHECK(c.criteria[0].detected_at->reading == c.onset_detected_at->reading);
  CHECK_FALSE(c.criteria[1].detected_at);
  REQUIRE(c.criteria[2].detected_at);
}

TEST_CASE("what only the end of the record shows was never noticed") {
  // Found by the windows that finish() closes, or by states that come when all is over.
  SyntheticPath path;
  CollapseMonitor monitor(undrained_header());
  for (int i = 0; i < 5000; ++i) monitor.watch(path.state(i), std::nullopt);
  const Collapse c = monitor.finish();
  CHECK(c.detected());
  CHECK_FALSE(c.onset_detected_at);
  CHECK_FALSE(c.criteria[0].detected_at);
}

TEST_CASE("what was found so far can be asked for at any time, and changes nothing") {
  SyntheticPath path;
  CollapseMonitor monitor(undrained_header()), other(undrained_header());
  std::vector<CollapseKind> kinds;
  for (int i = 0; i < 5000; ++i) {
    if (i % 500 == 0) kinds.push_back(monitor.so_far().kind);
    monitor.watch(path.state(i));
  }
  SyntheticPath same;
  for (int i = 0; i < 5000; ++i) other.watch(same.state(i));
  // The peak is at 600; half the strength is lost later.
  CHECK(kinds[0] == CollapseKind::none);
  CHECK(kinds[1] == CollapseKind::none);
  CHECK(kinds.back() == CollapseKind::flow);
  const Collapse one = monitor.finish(), two = other.finish();
  CHECK(one.kind == two.kind);
  CHECK(one.onset->reading == two.onset->reading);
  CHECK(one.onset->q_pa == two.onset->q_pa);
}

TEST_CASE("through noise the onset stays near, over many seeds") {
  for (int seed = 1; seed <= 30; ++seed) {
    SyntheticPath path;
    path.q_noise = path.u_noise = 150;
    path.rng.seed(std::uint64_t(seed));
    const Collapse c = judge(path, 5000);
    INFO("seed " << seed);
    REQUIRE(c.kind == CollapseKind::flow);
    CHECK(std::fabs(*c.onset->eta() - 140e3 / path.p(path.peak_strain)) < 0.05);
  }
}

TEST_CASE("hardening to the end is no collapse, over many seeds") {
  for (int seed = 1; seed <= 30; ++seed) {
    SyntheticPath path;
    path.peak_strain = 0.05;
    path.q_noise = path.u_noise = 300;
    path.rng.seed(std::uint64_t(seed));
    const Collapse c = judge(path, 4900);  // ends just before the peak
    INFO("seed " << seed);
    CHECK(c.kind == CollapseKind::none);
    CHECK_FALSE(c.criteria[0].found());
  }
}

TEST_CASE("strength that comes back makes the collapse a limited one") {
  CollapseMonitor monitor(undrained_header());
  SyntheticPath path;
  for (int i = 0; i < 5000; ++i) {
    State s = path.state(i);
    const double recovery = i > 1200 ? (i - 1200) * 60.0 : 0.0;  // dilation after the minimum
    s.q += recovery;
    s.p_eff += recovery;
    monitor.watch(s);
  }
  const Collapse c = monitor.finish();
  CHECK(c.kind == CollapseKind::limited);
  CHECK(std::abs(c.onset->reading - 600) <= 3);
}

TEST_CASE("softening on the limit surface is no diffuse collapse") {
  RecordHeader header = undrained_header();
  header.specimen.limit_friction_angle_rad = triax::sim::radians(18);  // M 0.69, close to the onset
  SyntheticPath path;
  const double eta = path.q(path.peak_strain) / path.p(path.peak_strain);
  REQUIRE(eta > 0.95 * triax::sim::stress_ratio_at_friction_angle(triax::sim::radians(18)));
  const Collapse c = judge(path, 5000, header);
  CHECK(c.kind == CollapseKind::none);
  CHECK(c.inside_limit_surface == false);
}

TEST_CASE("a record without time runs along its strain and finds the same onset") {
  RecordHeader header = undrained_header();
  header.has_time = false;
  const Collapse c = judge({}, 5000, header);
  CHECK(c.kind == CollapseKind::flow);
  CHECK(std::abs(c.onset->reading - 600) <= 3);
  CHECK_FALSE(c.onset->time_s);
}

TEST_CASE("a point of second-order work lies at a time, or on the way along the axial strain") {
  for (const bool has_time : {true, false}) {
    RecordHeader header = undrained_header();
    header.has_time = has_time;
    SyntheticPath path;
    int points = 0;
    CollapseListener listener;
    listener.second_order_work = [&](const SecondOrderWorkPoint& p) {
      ++points;
      const int i = static_cast<int>(p.reading);
      const State at = path.state(i), next = path.state(i + 1);  // points lie between readings
      CHECK(std::isnan(p.time_s) == !has_time);
      CHECK(std::isnan(p.axial_strain_path) == has_time);
      if (has_time)
        CHECK(p.time_s == Approx(at.time_s).margin(next.time_s - at.time_s));
      else
        CHECK(p.axial_strain_path ==
              Approx(at.strain.axial).margin(next.strain.axial - at.strain.axial));
    };
    CollapseMonitor monitor(header, {listener});
    for (int i = 0; i < 2000; ++i) monitor.watch(path.state(i));
    monitor.finish();
    CHECK(points > 10);
  }
}

TEST_CASE("nothing but consolidation is not judged") {
  RecordHeader header = undrained_header();
  header.stages[0].role = StageRole::consolidation;
  const Collapse c = judge({}, 5000, header);
  CHECK_FALSE(c.judged);
  CHECK_FALSE(c.onset);
}

TEST_CASE("extension collapses like compression, mirrored") {
  CollapseMonitor monitor(undrained_header());
  SyntheticPath path;
  for (int i = 0; i < 5000; ++i) {
    State s = path.state(i);
    s.strain = {-s.strain.axial, -s.strain.radial};
    s.q = -s.q * 0.5;
    monitor.watch(s);
  }
  const Collapse c = monitor.finish();
  REQUIRE(c.kind == CollapseKind::flow);
  CHECK(std::abs(c.onset->reading - 600) <= 3);
  CHECK(*c.onset->q_pa == Approx(-70e3).epsilon(1e-3));
  CHECK(*monitor.peak()->q_pa == Approx(-70e3).epsilon(1e-3));
}

TEST_CASE("a drained path whose volume is unknown is not judged; an unknown u stays unknown") {
  CollapseMonitor blind(undrained_header()), dry(undrained_header());
  SyntheticPath path;
  for (int i = 0; i < 5000; ++i) {
    State s = path.state(i);
    s.pore_pressure = kMissing;
    dry.watch(s);
    s.volumetric_strain = kMissing;
    blind.watch(s);
  }
  CHECK_FALSE(blind.finish().judged);
  const Collapse c = dry.finish();
  CHECK(c.kind == CollapseKind::flow);
  CHECK_FALSE(c.onset->pore_pressure_pa);
}

TEST_CASE("a gap in volume or pore pressure is passed over, a record without u is judged") {
  const auto judged = [](auto change) {
    CollapseMonitor monitor(undrained_header());
    SyntheticPath path;
    for (int i = 0; i < 5000; ++i) {
      State s = path.state(i);
      s.volumetric_strain = 0.01;
      change(i, s);
      monitor.watch(s);
    }
    return monitor.finish();
  };
  const Collapse gaps = judged([](int i, State& s) {
    if (i % 10 == 3) s.volumetric_strain = kMissing;
    if (i % 10 == 6) s.pore_pressure = kMissing;
  });
  CHECK(gaps.kind == CollapseKind::flow);
  CHECK(std::abs(gaps.onset->reading - 600) <= 4);
  const Collapse without = judged([](int, State& s) { s.pore_pressure = kMissing; });
  CHECK(without.kind == CollapseKind::flow);
  CHECK(std::abs(without.onset->reading - 600) <= 3);
}

TEST_CASE("missing values are passed over") {
  CollapseMonitor monitor(undrained_header());
  SyntheticPath path;
  for (int i = 0; i < 5000; ++i) {
    State s = path.state(i);
    if (i % 10 == 3) s.q = kMissing;
    monitor.watch(s);
  }
  const Collapse c = monitor.finish();
  CHECK(c.kind == CollapseKind::flow);
  CHECK(std::abs(c.onset->reading - 600) <= 4);
}

TEST_CASE("at held q, drained, through a volume in coarse steps the onset is where it turns") {
  // Half a day of slow unloading: the volume passes its minimum by a step in 200 readings, on
  // either side, then the specimen runs away within a minute.
  constexpr int kTurn = 6000, kRunAway = 6500;
  RecordHeader header = undrained_header();
  header.stages[0].drainage = Drainage::open;
  header.stages[0].control = AxialControl::constant_q;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    std::mt19937_64 rng(seed);
    std::normal_distribution<double> unit(0, 1);
    CollapseMonitor monitor(header);
    for (int i = 0; i < kRunAway + 60; ++i) {
      const double t = i - kTurn, run = i > kRunAway ? 1e-3 * (i - kRunAway) : 0.0;
      State s;
      s.reading = i;
      s.time_s = i;
      s.volumetric_strain = std::round(2e-6 * t * t / 4e4 / 2e-6) * 2e-6 + 0.1 * run;
      s.strain.axial = 2e-3 + 5e-8 * i + run + 5e-6 * unit(rng);
      s.q = 90e3 * (1 - 10 * run) + 150 * unit(rng);
      s.p_eff = 250e3 - 15.0 * i + 80 * unit(rng);
      s.pore_pressure = 300e3 + 80 * unit(rng);
      s.effective_stress = {s.p_eff + 2 * s.q / 3, s.p_eff - s.q / 3};
      monitor.watch(s);
    }
    const Collapse c = monitor.finish();
    INFO("seed " << seed);
    REQUIRE(c.onset);
    CHECK(std::abs(c.onset->reading - kTurn) <= 20);
    CHECK(std::fabs(*c.onset->eta() - 90e3 / (250e3 - 15.0 * kTurn)) < 0.003);
  }
}

namespace {

struct HeldTest {
  std::vector<Event> events;
  Collapse collapse;
};

/// Half a day at held q, drained, while p′ falls: the volume turns at reading 3000 if it `turns`.
HeldTest held_test(bool turns, int readings, int runs_away_at) {
  RecordHeader header = undrained_header();
  header.stages[0].drainage = Drainage::open;
  header.stages[0].control = AxialControl::constant_q;
  HeldTest test;
  CollapseMonitor monitor(header,
                          {{.happened = [&](const Event& e) { test.events.push_back(e); }}});
  std::mt19937_64 rng(5);
  std::normal_distribution<double> unit(0, 1);
  for (int i = 0; i < readings; ++i) {
    const double t = i - 3000.0, run = i > runs_away_at ? 1e-3 * (i - runs_away_at) : 0.0;
    State s;
    s.reading = i;
    s.time_s = i;
    s.volumetric_strain = (turns ? 2e-10 * t * t : -1e-7 * i) + 0.1 * run + 1e-6 * unit(rng);
    s.strain.axial = 2e-3 + 5e-7 * i + run + 5e-6 * unit(rng);
    s.q = 90e3 * (1 - 10 * run) + 150 * unit(rng);
    s.p_eff = 250e3 - 20.0 * i + 80 * unit(rng);
    s.pore_pressure = 300e3 + 80 * unit(rng);
    s.effective_stress = {s.p_eff + 2 * s.q / 3, s.p_eff - s.q / 3};
    monitor.watch(s);
  }
  test.collapse = monitor.finish();
  return test;
}

}  // namespace

TEST_CASE("CollapseMonitor: the turn at held q is reported before the fall") {
  const HeldTest test = held_test(true, 6000, 5900);
  REQUIRE_FALSE(test.events.empty());
  CHECK(test.events.front().kind == EventKind::loss_of_sustainability);
  CHECK(std::abs(test.events.front().reading - 3000) < 500);
  CHECK(test.events.size() == 1);
  REQUIRE(test.collapse.onset_detected_at);
  CHECK(test.collapse.onset_detected_at->reading < 5900);
  CHECK(test.collapse.kind == CollapseKind::flow);
  CHECK(held_test(false, 5000, 5000).events.empty());
}

TEST_CASE("CollapseMonitor: a record that ends past the turn at held q is not assessed") {
  CHECK_FALSE(held_test(true, 5000, 5000).collapse.judged);
  CHECK(held_test(true, 2000, 2000).collapse.judged);
  CHECK(held_test(false, 5000, 5000).collapse.judged);
}
