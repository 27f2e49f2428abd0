// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/spread_times.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace triax::lab;

namespace {

struct SpreadRows {
  std::vector<double> times;
  std::vector<Warning> warnings;
  bool failed = false;
};

constexpr double kFails = -1;

SpreadRows spread_rows(const std::vector<double>& stamps, const std::vector<double>& stages = {}) {
  SpreadRows out;
  Findings findings(out.warnings);
  std::size_t at = 0;
  SpreadTimes times(
      [&](Row& row) {
        if (at == stamps.size()) return false;
        if (stamps[at] == kFails) throw std::runtime_error("unreadable");
        row.time_s = stamps[at];
        if (!stages.empty()) row.stage = stages[at];
        row.line = static_cast<std::int64_t>(++at);
        return true;
      },
      false, findings);
  try {
    while (const Row* const row = times.next()) out.times.push_back(row->time_s);
  } catch (const std::runtime_error&) {
    out.failed = true;
  }
  return out;
}

}  // namespace

TEST_CASE("SpreadTimes: readings of a rounded clock are evenly spread") {
  const auto rows = spread_rows({0, 0.1, 0.1, 0.2, 0.2, 0.2, 0.2, 0.3});
  const std::vector<double> expected{0, 0.1, 0.15, 0.2, 0.225, 0.25, 0.275, 0.3};
  REQUIRE(rows.times.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(rows.times[i] == Approx(expected[i]));
  REQUIRE(rows.warnings.size() == 1);
  CHECK(rows.warnings[0].line == 3);
  CHECK(rows.warnings[0].text ==
        "the time 0.1 s appears 2 times: these rows are spread evenly up "
        "to 0.2 s");
}

TEST_CASE("SpreadTimes: times that increase or have no successor keep their bits") {
  const std::vector<double> running{0.1, 0.2, 0.30000000000000004, 5};
  CHECK(spread_rows(running).times == running);
  CHECK(spread_rows(running).warnings.empty());
  const std::vector<double> last{1, 2, 2}, back{5, 5, 1};
  CHECK(spread_rows(last).times == last);
  CHECK(spread_rows(back).times == back);
  const std::vector<double> stage_follows{1, 1, 9};
  CHECK(spread_rows(stage_follows, {1, 1, 2}).times == stage_follows);
  CHECK(spread_rows({}).times.empty());
}

TEST_CASE("SpreadTimes: the last rows of a rounded clock are as far apart as those before") {
  const std::vector<double> fewer{0, 20, 40, 60, 80, 100, 120, 140};
  CHECK(spread_rows({0, 0, 0, 60, 60, 60, 120, 120}).times == fewer);
  const std::vector<double> more{0, 30, 60, 75, 90, 105};
  CHECK(spread_rows({0, 0, 60, 60, 60, 60}).times == more);
  const std::vector<double> other_stage{0, 30, 60, 90, 0, 0};
  CHECK(spread_rows({0, 0, 60, 60, 0, 0}, {1, 1, 1, 1, 2, 2}).times == other_stage);
}

TEST_CASE("SpreadTimes: a clock that stands still is read in constant memory") {
  const std::vector<double> stands(3 * SpreadTimes::kMaxRows, 7.0);
  CHECK(spread_rows(stands).times == stands);
}

TEST_CASE("SpreadTimes: a failure comes after the rows before it") {
  const auto rows = spread_rows({1, 1, kFails});
  CHECK(rows.failed);
  CHECK(rows.times == std::vector<double>{1, 1});
}
