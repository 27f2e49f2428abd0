// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/axis_rest.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "lab/collapse/monitor.hpp"
#include "tests/lab/measured/synthetic_path.hpp"

using namespace triax::lab;
using triax::lab::testing::SyntheticPath;
using triax::lab::testing::undrained_header;

namespace {

/// A frame that follows the path, and stands from one reading to another: q relaxes meanwhile with
/// the logarithm of time, as load cell and frame let the specimen shorten a little; then it goes
/// on.
struct Drive {
  SyntheticPath path;
  int stops = 3000, goes_on = 1 << 30;
  double relaxation = 0.08;  ///< of q, a decade of readings: beyond what counts as a loss
  double creep = 1e-7;       ///< axial strain a reading

  State state(int i) {
    const int rested = std::clamp(i - stops, 0, goes_on - stops);
    State s = path.state(i - rested);
    s.reading = i;
    s.time_s = path.state(i).time_s;
    if (i <= stops || i >= goes_on) return s;
    const double fall = s.q * relaxation * std::log10(1.0 + rested);
    s.q -= fall;
    s.p_eff -= fall / 3;
    s.strain.axial += creep * rested;
    return s;
  }
};

Collapse judge(Drive drive, int readings, const RecordHeader& header = undrained_header()) {
  CollapseMonitor monitor(header);
  for (int i = 0; i < readings; ++i) monitor.watch(drive.state(i));
  return monitor.finish();
}

Drive hardening() {
  Drive drive;
  drive.path.peak_strain = 0.05;  // beyond the end
  return drive;
}

}  // namespace

TEST_CASE("relaxation at the end of a test that hardened is no collapse") {
  const bool has_time = GENERATE(true, false);
  const int rest = GENERATE(20, 200, 1500);
  RecordHeader header = undrained_header();
  header.has_time = has_time;
  const Collapse c = judge(hardening(), 3000 + rest, header);
  INFO(rest << " readings of rest, time " << has_time);
  CHECK(c.judged);
  CHECK(c.kind == CollapseKind::none);
  CHECK_FALSE(c.onset);
}

TEST_CASE("a pause within a test that hardens is no collapse") {
  Drive drive = hardening();
  drive.stops = 1500;
  drive.goes_on = 2500;
  const Collapse c = judge(drive, 5000);
  CHECK(c.judged);
  CHECK(c.kind == CollapseKind::none);
  CHECK_FALSE(c.onset);
}

TEST_CASE("a collapse is seen before a rest and after one") {
  Drive drive;  // peak at reading 600
  drive.stops = 300;
  drive.goes_on = 800;
  const Collapse after = judge(drive, 5500);
  CHECK(after.kind == CollapseKind::flow);
  CHECK(std::abs(after.onset->reading - 1100) <= 10);

  drive.stops = 3000;
  drive.goes_on = 1 << 30;
  const Collapse before = judge(drive, 5000);
  CHECK(before.kind == CollapseKind::flow);
  CHECK(std::abs(before.onset->reading - 600) <= 3);
}

TEST_CASE("a drive that goes twenty times slower is driven all the same") {
  SyntheticPath path;
  CollapseMonitor monitor(undrained_header());
  for (int i = 0; i < 4000; ++i) {
    // From reading 500 on, before the peak, a reading comes twenty times as often.
    State s = path.state(i);
    if (i > 500) s.time_s = path.state(500).time_s + (s.time_s - path.state(500).time_s) * 20;
    monitor.watch(s);
  }
  const Collapse c = monitor.finish();
  CHECK(c.kind == CollapseKind::flow);
  CHECK(std::abs(c.onset->reading - 600) <= 3);
}

TEST_CASE("q that is lost while the strain does not move at all leaves the rest unjudged") {
  Drive drive = hardening();
  drive.relaxation = 0.25;
  drive.creep = 0;
  drive.stops = 800;
  const Collapse c = judge(drive, 2300);
  CHECK_FALSE(c.judged);
  CHECK(c.kind == CollapseKind::none);
  REQUIRE(c.judged_until);
  CHECK(std::abs(*c.judged_until - 800) <= 120);  // windows are as long as an eighth of the stage
  CHECK(c.judged_until_reason.find("axial strain did not move") != std::string::npos);
}

TEST_CASE("q that goes on to the other sign was driven while the strain did not move") {
  SyntheticPath path = hardening().path;
  const auto judged_until_the_end = [&](double last_share) {
    CollapseMonitor monitor(undrained_header());
    for (int i = 0; i < 2300; ++i) {
      const double share = i <= 800 ? 1 : std::max(last_share, 1 - (i - 800) / 800.0);
      State s = path.state(std::min(i, 800));
      s.reading = i;
      s.time_s = path.state(i).time_s;
      s.p_eff += (share - 1) * s.q / 3;
      s.strain.axial -= std::max(0.0, 0.3 - share) * 1e-3;  // at first below the digits
      s.q *= share;
      monitor.watch(s);
    }
    return monitor.finish().judged;
  };
  CHECK(judged_until_the_end(-0.5));
  CHECK_FALSE(judged_until_the_end(0.3));
}

TEST_CASE("where there is no strength to lose, q about zero at rest leaves no doubt") {
  Drive drive = hardening();
  drive.path.q_peak = 2e3;  // of a p' of hundreds: noise and friction
  drive.relaxation = 0.4;
  drive.creep = 0;
  const Collapse c = judge(drive, 4000);
  CHECK(c.judged);
  CHECK(c.judged_until_reason.empty());
}
