// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/judged_states.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/lab/health/noisy_states.hpp"
#include "tests/lab/reduction/raw_record.hpp"

using namespace triax::lab;
using triax::lab::testing::noisy;
using triax::lab::testing::raw_header;
using triax::lab::testing::state_of;

namespace {

struct Run {
  std::vector<JudgedStates::Judged> passed;
  Collapse verdict;
  std::vector<Warning> warnings;
  std::size_t most_held = 0;
  bool ends_at_mark = false, trusts_axis = false;
};

/// q is 100 kPa from the first reading on.
RecordHeader loaded_header() {
  RecordHeader header = raw_header();
  header.programme = "CAU";
  return header;
}

template <class Break>
Run run(std::int64_t n, Break broken, double q_after = 100e3,
        const RecordHeader& header = loaded_header()) {
  JudgedStates states(header);
  Run out;
  const auto take = [&] {
    while (const auto* judged = states.next()) out.passed.push_back(*judged);
  };
  for (std::int64_t i = 0; i < n; ++i) {
    Reading r = noisy(i);
    broken(r);
    states.add(r, state_of(r, i > 400 ? q_after : 100e3));
    take();
    out.most_held = std::max(out.most_held, static_cast<std::size_t>(i + 1) - out.passed.size());
  }
  states.finish();
  take();
  states.bound(out.verdict);
  out.trusts_axis = states.trusts_axis();
  out.warnings = states.warnings();
  return out;
}

Run with_gap(double q_after) {
  return run(
      600,
      [](Reading& r) {
        if (r.number >= 300 && r.number < 400) r[Quantity::axial_force] = kMissing;
      },
      q_after);
}

}  // namespace

TEST_CASE("sound sensors: every state passes, once, in order, soon") {
  const Run out = run(1000, [](Reading&) {});
  REQUIRE(out.passed.size() == 1000);
  for (std::size_t i = 0; i < out.passed.size(); ++i) {
    REQUIRE(out.passed[i].reading.number == static_cast<std::int64_t>(i));
    REQUIRE(out.passed[i].live);
    REQUIRE_FALSE(out.passed[i].after_gap);
  }
  CHECK(out.most_held <= 8);
  CHECK_FALSE(out.verdict.judged_until);
  CHECK(out.verdict.judged);
  CHECK(out.warnings.empty());
}

TEST_CASE("a stuck sensor is known late, but none of its states was judged") {
  const Run out = run(600, [held = 0.0](Reading& r) mutable {
    if (r.number == 300) held = r[Quantity::pore_pressure];
    if (r.number > 300) r[Quantity::pore_pressure] = held;
  });
  for (const auto& judged : out.passed) CHECK(judged.live == (judged.reading.number <= 300));
  CHECK(out.passed.back().axis_live);
  CHECK(std::isnan(axis_of(out.passed.back()).p_eff));
  CHECK(std::isnan(axis_of(out.passed.back()).pore_pressure));
  CHECK(axis_of(out.passed.back()).q == 100e3);
  CHECK(out.trusts_axis);
  CHECK(out.verdict.judged_until == 300);
  CHECK(out.verdict.judged_until_reason == "the pore-pressure transducer (pore_pressure) is stuck");
  CHECK(out.warnings.back().text ==
        "not assessed after reading 300: the pore-pressure transducer (pore_pressure) is stuck");
}

TEST_CASE("a dead load cell or displacement leaves nothing known of the axis") {
  for (const Quantity dead : {Quantity::axial_force, Quantity::axial_displacement}) {
    const Run out = run(600, [dead](Reading& r) {
      if (r.number > 300) r[dead] = kMissing;
    });
    CHECK_FALSE(out.passed.back().live);
    CHECK_FALSE(out.passed.back().axis_live);
  }
}

TEST_CASE("a sensor that is said to be sound is told and believed; without it the remedy is told") {
  const auto hold = [held = 0.0](Reading& r) mutable {
    if (r.number == 300) held = r[Quantity::pore_pressure];
    if (r.number > 300) r[Quantity::pore_pressure] = held;
  };
  RecordHeader header = raw_header();
  CHECK_THAT(run(600, hold, 100e3, header).warnings.front().text,
             Catch::EndsWith("; if the sensor is not faulty: --set sensors.pore_pressure=sound"));
  header.vouched = {Quantity::pore_pressure};
  const Run out = run(600, hold, 100e3, header);
  CHECK(std::ranges::all_of(out.passed, [](const auto& one) { return one.live; }));
  CHECK(out.verdict.judged);
  CHECK_FALSE(out.verdict.judged_until);
  CHECK_THAT(out.warnings.front().text,
             Catch::EndsWith("; used because the user confirmed it (=sound)"));
}

TEST_CASE("a strain that slipped back after the peak ends the verdict there") {
  JudgedStates states(raw_header());
  for (std::int64_t i = 0; i < 90; ++i) {
    const Reading r = noisy(i);
    State s = state_of(r, 1e3 * double(i <= 50 ? 2 * i : 200 - 2 * i));
    s.p_eff = 1e3 * double(i <= 50 ? 200 - i : 150 - 3 * (i - 50));
    s.strain.axial = 1e-4 * double(i <= 50 ? i : 100 - i);
    states.add(r, s);
    while (states.next())
      ;
  }
  states.finish();
  while (states.next())
    ;
  Collapse assessed;
  states.bound(assessed);
  CHECK(assessed.judged_until == 50);
  CHECK_THAT(assessed.judged_until_reason, Catch::Contains("which is not an unloading"));
}

TEST_CASE("after a gap judgement goes on where nothing can have happened in it, else it ends") {
  const Run same = with_gap(95e3);
  CHECK_FALSE(same.verdict.judged_until);
  CHECK(same.passed[400].live);
  CHECK(same.passed[400].after_gap);
  CHECK_FALSE(same.passed[399].live);
  CHECK(same.passed.back().live);
  const Run lost = run(
      600,
      [](Reading& r) {
        if (r.number >= 300 && r.number < 402) r[Quantity::axial_force] = kMissing;
      },
      60e3);
  CHECK(lost.verdict.judged_until == 299);
  CHECK_FALSE(lost.passed.back().live);
}

TEST_CASE("a spike is left out, and no more") {
  const Run out = run(600, [](Reading& r) {
    if (r.number == 300) r[Quantity::cell_pressure] *= 2;
  });
  for (const auto& judged : out.passed) CHECK(judged.live == (judged.reading.number != 300));
  CHECK_FALSE(out.verdict.judged_until);
  CHECK(out.verdict.judged_until_reason.empty());
}

TEST_CASE("a sensor that serves no stress or strain does not end the verdict") {
  const Run out = run(600, [](Reading& r) {
    if (r.number > 300) r[Quantity::back_pressure] = 300e3;
  });
  CHECK(out.passed.back().live);
  CHECK((out.passed.back().wrong & channel_bit(Quantity::back_pressure)) != 0);
  REQUIRE(out.warnings.size() == 1);
  CHECK(out.warnings[0].text.find("(back_pressure) is stuck") != std::string::npos);
}

TEST_CASE("no strain counts from a displacement that was dead where shear began: not judged") {
  JudgedStates states(raw_header());
  for (std::int64_t i = 0; i < 1000; ++i) {
    Reading r = noisy(i);
    r.stage = i < 500 ? 2 : 3;
    if (i >= 300 && i < 600) r[Quantity::axial_displacement] = kMissing;
    states.add(r, state_of(r));
  }
  states.finish();
  while (const auto* judged = states.next())
    if (judged->reading.stage == 3) CHECK_FALSE(judged->live);
  Collapse verdict;
  states.bound(verdict);
  CHECK_FALSE(verdict.judged);
  CHECK_FALSE(verdict.judged_until);
  CHECK(verdict.judged_until_reason.find("axial_displacement") != std::string::npos);
}

namespace {

/// Drained to reading 100, then with the drainage shut, where u rises by 1 kPa in three readings
/// and q by 1 kPa in each; `broken` as above. What the load cell is off by goes into q.
template <class Break>
Run undrained(std::int64_t n, Break broken) {
  RecordHeader header = loaded_header();
  header.stages.push_back(
      {.number = 4, .name = "u", .role = StageRole::shear, .drainage = Drainage::closed});
  JudgedStates states(header);
  Run out;
  for (std::int64_t i = 0; i < n; ++i) {
    Reading r = noisy(i);
    r.stage = i < 100 ? 3 : 4;
    if (i >= 100) {
      r[Quantity::back_volume] = -5e-7;
      r[Quantity::pore_pressure] += 1e3 * double(i - 100) / 3;
    }
    const double force = r[Quantity::axial_force];
    broken(r);
    const double off_pa = (r[Quantity::axial_force] - force) / 3.848e-3;
    states.add(r, state_of(r, 100e3 + 1e3 * double(std::max<std::int64_t>(i - 100, 0)) + off_pa));
    while (const auto* judged = states.next()) out.passed.push_back(*judged);
  }
  states.finish();
  while (const auto* judged = states.next()) out.passed.push_back(*judged);
  out.ends_at_mark = states.ends_at_mark();
  states.bound(out.verdict);
  out.warnings = states.warnings();
  return out;
}

std::int64_t last_mark(const Run& run) {
  std::int64_t last = -1;
  for (const auto& judged : run.passed)
    if (judged.mark) last = judged.reading.number;
  return last;
}

}  // namespace

TEST_CASE("an undrained stage with sound sensors is judged to its end") {
  const Run out = undrained(400, [](Reading&) {});
  CHECK(out.passed.size() == 400);
  for (const auto& judged : out.passed) CHECK(judged.live);
  CHECK_FALSE(out.ends_at_mark);
  CHECK_FALSE(out.verdict.judged_until);
  CHECK(out.warnings.empty());
}

TEST_CASE("water through a shut valve: of no state after it more is judged than the axis") {
  const Run out = undrained(400, [](Reading& r) {
    if (r.number > 200) r[Quantity::back_volume] += 1e-7 * double(r.number - 200);
  });
  for (const auto& judged : out.passed) CHECK(judged.axis_live == !judged.live);
  // 5 · 10⁻⁴ of the volume are 269 mm³.
  for (const auto& judged : out.passed) CHECK(judged.live == (judged.reading.number <= 202));
  CHECK_FALSE(out.ends_at_mark);
  CHECK(out.verdict.judged_until == 202);
  CHECK(out.verdict.judged_until_reason.find("water flows although the valve is closed") == 0);
}

TEST_CASE("a valve that turns out to have opened: the verdict is that of the mark before") {
  const Run out = undrained(400, [](Reading& r) {
    if (r.number <= 200) return;
    const double noise = r[Quantity::pore_pressure] - 300e3 - 1e3 * double(r.number - 100) / 3;
    r[Quantity::pore_pressure] = 300e3 + noise + 33e3 * std::exp(-double(r.number - 200) / 4);
  });
  CHECK(out.ends_at_mark);
  CHECK(out.verdict.judged_until == last_mark(out) - 1);
  CHECK(std::abs(*out.verdict.judged_until - 200) <= 1);
  CHECK(out.verdict.judged_until_reason.find("the valve is open") != std::string::npos);
}

TEST_CASE("air in the pores, not an open valve: what u does at last lifts the suspicion") {
  // u rests from reading 100 on, and p falls by 50 kPa meanwhile.
  const auto resting_until = [](std::int64_t collapse) {
    return [collapse](Reading& r) {
      if (r.number < 100) return;
      r[Quantity::pore_pressure] -= 1e3 * double(r.number - 100) / 3;
      if (r.number > collapse) r[Quantity::pore_pressure] += 1e3 * double(r.number - collapse);
    };
  };
  const Run open = undrained(250, resting_until(400));
  CHECK(open.ends_at_mark);
  CHECK(open.verdict.judged_until == 99);
  const Run closed = undrained(250, resting_until(220));
  CHECK_FALSE(closed.ends_at_mark);
  CHECK_FALSE(closed.verdict.judged_until);
  CHECK(std::ranges::all_of(closed.passed, [](const auto& judged) { return judged.live; }));
  CHECK(last_mark(closed) == 100);
}

TEST_CASE("undrained and the volume gauge dies: nobody knows any more whether the valve is shut") {
  const Run out = undrained(400, [](Reading& r) {
    if (r.number > 200) r[Quantity::back_volume] = kMissing;
  });
  CHECK(out.verdict.judged_until == 200);
  CHECK(out.verdict.judged_until_reason.find("(back_volume) gives no readings") !=
        std::string::npos);
  // It died before the valve was shut: the same.
  const Run before = undrained(400, [](Reading& r) {
    if (r.number > 60) r[Quantity::back_volume] = kMissing;
  });
  CHECK(before.verdict.judged_until == 60);
}

TEST_CASE("a logger that writes no volume while the drainage is shut loses no verdict") {
  const Run out = undrained(400, [](Reading& r) {
    if (r.stage == 4) r[Quantity::back_volume] = kMissing;
  });
  for (const auto& judged : out.passed) CHECK(judged.live);
  CHECK_FALSE(out.verdict.judged_until);
}

TEST_CASE("undrained, a load cell that spikes or dies early is no load that u fails to answer") {
  // 900 N are 78 kPa of mean stress, by which u does not move.
  const Run spiked = undrained(400, [](Reading& r) {
    if (r.number == 104) r[Quantity::axial_force] += 900;
  });
  for (const auto& judged : spiked.passed) CHECK(judged.live == (judged.reading.number != 104));
  CHECK(spiked.verdict.judged);
  CHECK_FALSE(spiked.verdict.judged_until);
  const Run dead = undrained(400, [](Reading& r) {
    if (r.number >= 104) r[Quantity::axial_force] = 2000;
  });
  CHECK(dead.verdict.judged_until == 103);
  CHECK(dead.verdict.judged_until_reason.find("the load cell (axial_force) is saturated") == 0);
  // At the first reading with the valve shut: the stresses that it starts from are not that one's.
  const Run first = undrained(400, [](Reading& r) {
    if (r.number == 100) r[Quantity::axial_force] += 900;
  });
  CHECK(first.verdict.judged);
  CHECK_FALSE(first.verdict.judged_until);
}

TEST_CASE("a sensor that died in the last readings of shear ends the verdict before them") {
  const auto held_from = [](std::int64_t hold) {
    RecordHeader header = raw_header();
    header.stages.push_back({.number = 4, .name = "hold", .role = StageRole::hold});
    JudgedStates states(header);
    for (std::int64_t i = 0; i < 400; ++i) {
      Reading r = noisy(i);
      if (i >= hold) r.stage = 4;
      if (i >= 300) r[Quantity::axial_force] = 2000;
      states.add(r, state_of(r));
    }
    states.finish();
    while (states.next()) continue;
    Collapse verdict;
    states.bound(verdict);
    return verdict;
  };
  for (const std::int64_t hold : {302, 310}) {
    CHECK(held_from(hold).judged_until == 299);
    CHECK(held_from(hold).judged_until_reason.find("the load cell") == 0);
  }
  // It died afterwards.
  CHECK_FALSE(held_from(300).judged_until);
}
