#include "lab/health/judged_states.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "lab/devices/noise.hpp"
#include "tests/lab/reduction/raw_record.hpp"

using namespace triax::lab;
using triax::lab::testing::raw_header;

namespace {

/// A noisy reading of stage 3 and a state of q 100 kPa, p' 100 kPa that goes with it.
Reading noisy(std::int64_t i) {
  Reading r = triax::lab::testing::reading({3, 0.001 * double(i), 0.4, 400, 300, 0}, i);
  for (std::size_t k = 0; k < 5; ++k)
    r.si[k] += 1e-4 * std::abs(r.si[k] + 1e-3) * standard_normal(1, k, std::uint64_t(i));
  return r;
}
State state_of(const Reading& r, double q = 100e3) {
  State s;
  s.reading = r.number;
  s.time_s = r.time_s;
  s.stage = r.stage;
  s.q = q;
  s.p_eff = 100e3;
  s.strain = {1e-6 * double(r.number), 0};
  s.volumetric_strain = 0;
  s.pore_pressure = 300e3;
  return s;
}

struct Run {
  std::vector<JudgedStates::Judged> passed;
  Collapse verdict;
  std::vector<Warning> warnings;
  std::size_t most_held = 0;
};

template <class Break>
Run run(std::int64_t n, Break broken, double q_after = 100e3) {
  JudgedStates states(raw_header());
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
  CHECK(out.verdict.judged_until == 300);
  CHECK(out.verdict.judged_until_reason == "the pore-pressure transducer (pore_pressure) is stuck");
  CHECK(out.warnings.back().text ==
        "no verdict after reading 300: the pore-pressure transducer (pore_pressure) is stuck");
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
