// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/alarm.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/warning/warning_limits.hpp"
#include "tests/lab/warning/loose_path.hpp"

using namespace triax::lab;
using triax::lab::testing::LoosePath;
using triax::lab::testing::shear_header;

namespace {

struct Said {
  std::vector<Event> events;
  std::vector<Forecast> forecasts;
  AlarmListener listener() {
    return {.foreseen = [this](const Forecast& o) { forecasts.push_back(o); },
            .happened = [this](const Event& e) { events.push_back(e); }};
  }
  const Event* first(EventKind kind) const {
    for (const Event& e : events)
      if (e.kind == kind) return &e;
    return nullptr;
  }
};

constexpr int kReadingsUnderLoad = 1000;

/// By a load that grows to that share of the largest that the specimen carries.
void load(Alarm& alarm, LoosePath path, double to) {
  for (int i = 1; i <= kReadingsUnderLoad; ++i)
    alarm.watch(path.at(path.eta_under_load(to * i / kReadingsUnderLoad), i));
}

}  // namespace

TEST_CASE("under a load the alarm comes before the fall and says what is left of it") {
  Said said;
  const RecordHeader header = shear_header(AxialControl::load);
  Alarm alarm(header, {said.listener()});
  load(alarm, LoosePath{.noise_pa = 30, .noise_strain = 1e-6}, 0.9999);
  const Event* soon = said.first(EventKind::imminent);
  REQUIRE(soon);
  CHECK(soon->reading < kReadingsUnderLoad - 10);  // a second each
  CHECK(alarm.level() == WarningLevel::imminent);
  REQUIRE(alarm.imminent());
  const Forecast& o = *alarm.imminent();
  CHECK(o.reading == soon->reading);
  CHECK(o.eta == Approx(0.6).margin(0.03));
  CHECK(o.eta_low < 0.6);
  CHECK(0.6 < o.eta_high);
  REQUIRE(o.left);
  CHECK(o.left->quantity == Quantity::deviator_stress);
  const double q_left =
      1e5 * 0.3 * (1 - 0.9999 * static_cast<double>(o.reading) / kReadingsUnderLoad);
  CHECK(o.left->value == Approx(q_left).epsilon(0.35));
  CHECK(*o.left->time_s ==
        Approx(kReadingsUnderLoad - static_cast<double>(o.reading)).epsilon(0.35));
}

TEST_CASE("a level that the test does not bear out is taken back aloud") {
  Said said;
  const RecordHeader header = shear_header(AxialControl::load);
  Alarm alarm(header, {said.listener()});
  LoosePath path{.noise_pa = 30, .noise_strain = 1e-6};
  load(alarm, path, 0.9999);
  REQUIRE(said.first(EventKind::imminent));
  CHECK_FALSE(said.first(EventKind::warning_withdrawn));
  alarm.interrupt("pore_pressure_kPa is stuck");
  REQUIRE(said.first(EventKind::warning_withdrawn));
  CHECK(said.first(EventKind::warning_withdrawn)->detail ==
        "warning withdrawn: pore_pressure_kPa is stuck");
  CHECK_FALSE(alarm.imminent());
}

TEST_CASE(
    "by displacement an onset is approaching first, then imminent, and then passed in silence") {
  Said said;
  const RecordHeader header = shear_header(AxialControl::displacement);
  Alarm alarm(header, {said.listener()});
  LoosePath path{.noise_pa = 30, .noise_strain = 1e-6};
  for (int i = 1; i <= kReadingsUnderLoad; ++i)
    alarm.watch(path.at(0.7 * i / kReadingsUnderLoad, i));
  REQUIRE(said.first(EventKind::approaching));
  REQUIRE(said.first(EventKind::imminent));
  CHECK(said.first(EventKind::approaching)->reading < said.first(EventKind::imminent)->reading);
  CHECK(said.first(EventKind::imminent)->reading < 857);  // η of 0.6
  // The forecast is told at every point of second-order work, though it stands still, and where a
  // level is reached, never twice at one reading.
  CHECK(said.forecasts.size() > 50);
  std::int64_t last = -1;
  int of_levels = 0;
  for (const Forecast& o : said.forecasts) {
    CHECK(o.reading > last);
    last = o.reading;
    for (const EventKind level : {EventKind::approaching, EventKind::imminent})
      if (said.first(level)->reading == o.reading) ++of_levels;
  }
  CHECK(of_levels == 2);
  CHECK_FALSE(said.first(EventKind::warning_withdrawn));
  CHECK(alarm.level() == WarningLevel::imminent);
}

TEST_CASE("nothing is said of an onset on the limit surface, nor where the stiffness stays") {
  Said said;
  RecordHeader header = shear_header(AxialControl::load);
  SECTION("φ of 16 degrees: M is 0.61, the onset forecast within 5 % of it") {
    header.specimen.limit_friction_angle_rad = 16.0 / 180 * 3.14159265358979;
    Alarm alarm(header, {said.listener()});
    load(alarm, LoosePath{.noise_pa = 30, .noise_strain = 1e-6}, 0.9999);
  }
  SECTION("an onset at three times the η that is reached") {
    Alarm alarm(header, {said.listener()});
    LoosePath path{.eta_onset = 1.5, .noise_pa = 30, .noise_strain = 1e-6};
    load(alarm, path, 0.6);
  }
  CHECK_FALSE(said.first(EventKind::approaching));
  CHECK_FALSE(said.first(EventKind::imminent));
}

TEST_CASE("after a loss nothing is imminent any more, and the levels that were said stand") {
  Said said;
  const RecordHeader header = shear_header(AxialControl::load);
  Alarm alarm(header, {said.listener()});
  LoosePath path{.noise_pa = 30, .noise_strain = 1e-6};
  load(alarm, path, 0.9999);
  alarm.lose();
  CHECK(alarm.level() == WarningLevel::lost);
  const auto events = said.events.size();
  for (int i = 1; i <= 200; ++i) alarm.watch(path.at(0.6 + 0.001 * i, kReadingsUnderLoad + i));
  CHECK(said.events.size() == events);
  CHECK(alarm.imminent());
}

TEST_CASE("states without q between the others change nothing that is said") {
  Said alone, after;
  const RecordHeader header = shear_header(AxialControl::displacement);
  Alarm one(header, {alone.listener()}), other(header, {after.listener()});
  LoosePath path;
  for (int i = 1; i <= kReadingsUnderLoad; ++i)
    one.watch(path.at(0.599 * i / kReadingsUnderLoad, i));
  for (int i = 1; i <= kReadingsUnderLoad; ++i) {
    State incomplete = path.at(0.3, i);
    incomplete.q = kMissing;
    other.watch(incomplete);
    other.watch(path.at(0.599 * i / kReadingsUnderLoad, i));
  }
  REQUIRE(alone.events.size() == after.events.size());
  REQUIRE(alone.first(EventKind::imminent));
  CHECK(alone.first(EventKind::imminent)->reading == after.first(EventKind::imminent)->reading);
}

TEST_CASE(
    "a loop in a stage of its own is no onset, and the stage after it is warned of as without") {
  RecordHeader header = shear_header(AxialControl::load);
  for (int number : {2, 3}) {
    header.stages.push_back(header.stages.front());
    header.stages.back().number = number;
  }
  LoosePath path{.noise_pa = 30, .noise_strain = 1e-6};
  Said said;
  Alarm alarm(header, {said.listener()});
  int reading = 0;
  const auto watch = [&](State s, int stage) {
    s.stage = stage;
    alarm.watch(s);
  };
  for (int i = 1; i <= 400; ++i) watch(path.at(0.15 * i / 400, ++reading), 1);
  // Fifty times as stiff as the specimen is on its path, down to a third of η and back.
  const State top = path.at(0.15, reading);
  const auto stiff = [&](double share) {
    State s = path.at(0.15, ++reading);
    s.q = top.q * share;
    s.strain.axial = top.strain.axial - (1 - share) * 0.15 * path.strain_per_eta / 50;
    return s;
  };
  for (int i = 1; i <= 100; ++i) watch(stiff(1 - 0.67 * i / 100), 2);
  for (int i = 1; i < 100; ++i) watch(stiff(0.33 + 0.67 * i / 100), 3);
  const int back = reading;
  for (int i = 1; i <= 600; ++i) {
    const double eta = path.eta_under_load(0.4375 + 0.5624 * i / 600);
    watch(path.at(eta, ++reading), 3);
  }
  const Event* soon = said.first(EventKind::imminent);
  REQUIRE(soon);
  CHECK(soon->reading > back + 300);
  CHECK(soon->reading < reading - 10);
}

namespace {

/// Cycles of q of 20 kPa about 0. p′ is `left` of 100 kPa. One stage, or one for each half cycle.
void apply_cycles(Alarm& alarm, double from, double to, double (*left)(double),
                  bool stage_each = false) {
  constexpr int kPerCycle = 80;
  for (int i = static_cast<int>(from * kPerCycle); i < to * kPerCycle; ++i) {
    const double n = static_cast<double>(i) / kPerCycle;
    State s;
    s.reading = i;
    s.time_s = i;
    s.stage = stage_each ? 1 + static_cast<int>(2 * n + 0.5) : 1;
    s.q = 2e4 * std::sin(2 * 3.14159265358979 * n);
    s.p_eff = 1e5 * left(n);
    s.strain.axial =
        2e-3 * s.q / s.p_eff - 1e-4 * std::cos(2 * 3.14159265358979 * n) / std::pow(left(n), 2);
    s.volumetric_strain = 0;
    alarm.watch(s);
  }
}

double flow_of_cycles(double n) { return std::sqrt(std::max(0.01, 1 - n / 10)); }
/// Falls from 0.9 to 0.4 in the fourth cycle and no further, as in cyclic mobility.
double mobility_of_cycles(double n) { return n < 4 ? 0.9 : std::max(0.4, 0.9 - 0.5 * (n - 4)); }

}  // namespace

TEST_CASE("Alarm: imminent within one load cycle of a cyclic failure", "[warning][cyclic]") {
  Said said;
  RecordHeader header = shear_header(AxialControl::load);
  bool stage_each = false;
  SECTION("one stage") {}
  SECTION("a stage for each half cycle") {
    stage_each = true;
    for (int number = 2; number < 25; ++number) {
      header.stages.push_back(header.stages.front());
      header.stages.back().number = number;
    }
  }
  Alarm alarm(header, {said.listener()});
  apply_cycles(alarm, 0, 9.5, flow_of_cycles, stage_each);
  CHECK(alarm.level() == WarningLevel::imminent);
  REQUIRE(alarm.imminent());
  REQUIRE(alarm.imminent()->cyclic);
  CHECK(alarm.imminent()->cyclic->probability >= warning_limits::kIssue);
  CHECK(alarm.imminent()->cyclic->load_cycles > 6);
  CHECK(std::isnan(alarm.imminent()->eta));
  const Event* imminent = said.first(EventKind::imminent);
  REQUIRE(imminent);
  CHECK(imminent->detail.find("the probability of failure within one load cycle is ") == 0);
  CHECK_FALSE(said.first(EventKind::warning_withdrawn));
  alarm.lose();
  CHECK(alarm.level() == WarningLevel::lost);
  CHECK(alarm.imminent());
}

TEST_CASE("Alarm: withdraws the cyclic warning with its probability", "[warning][cyclic]") {
  Said said;
  const RecordHeader header = shear_header(AxialControl::load);
  Alarm alarm(header, {said.listener()});
  apply_cycles(alarm, 0, 12, mobility_of_cycles);
  REQUIRE(said.first(EventKind::imminent));
  const Event* withdrawn = said.first(EventKind::warning_withdrawn);
  REQUIRE(withdrawn);
  CHECK(withdrawn->detail.find("warning withdrawn: the probability of failure within one load "
                               "cycle is ") == 0);
  CHECK(alarm.level() == WarningLevel::none);
  CHECK_FALSE(alarm.imminent());
}

TEST_CASE("Alarm: no cyclic warning unless the drainage is closed", "[warning][cyclic]") {
  Said said;
  const RecordHeader header = shear_header(AxialControl::load, Drainage::open);
  Alarm alarm(header, {said.listener()});
  apply_cycles(alarm, 0, 9.5, flow_of_cycles);
  for (const Event& event : said.events)
    CHECK(event.detail.find("load cycle") == std::string::npos);
}

TEST_CASE("Alarm: an interruption withdraws the cyclic warning", "[warning][cyclic]") {
  Said said;
  const RecordHeader header = shear_header(AxialControl::load);
  Alarm alarm(header, {said.listener()});
  apply_cycles(alarm, 0, 9, flow_of_cycles);
  REQUIRE(alarm.level() == WarningLevel::imminent);
  alarm.interrupt("pore_pressure_kPa is stuck");
  CHECK(alarm.level() == WarningLevel::none);
  REQUIRE(said.first(EventKind::warning_withdrawn));
  CHECK(said.first(EventKind::warning_withdrawn)->detail ==
        "warning withdrawn: pore_pressure_kPa is stuck");
}
