// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/backbone.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "lab/collapse/monitor.hpp"
#include "tests/lab/measured/synthetic_path.hpp"

using namespace triax::lab;
using triax::lab::testing::SyntheticPath;
using triax::lab::testing::undrained_header;

namespace {

struct Row {
  double strain, q, p;  // %, kPa, kPa
};

State state(std::int64_t number, const Row& row, double sign = 1) {
  State s;
  s.reading = number;
  s.time_s = static_cast<double>(number);
  s.strain = {sign * row.strain / 100, -sign * row.strain / 200};
  s.volumetric_strain = 0;
  s.q = sign * row.q * 1e3;
  s.p_eff = row.p * 1e3;
  s.pore_pressure = 0;
  s.effective_stress = {s.p_eff + 2 * s.q / 3, s.p_eff - s.q / 3};
  return s;
}

std::optional<BackboneFall> fall_of(const std::vector<Row>& rows, double sign = 1) {
  Backbone backbone;
  backbone.start_stage(false);
  std::int64_t number = 0;
  for (const Row& row : rows) backbone.add(state(number++, row, sign));
  return backbone.worst();
}

Collapse verdict_on(const std::vector<Row>& rows) {
  RecordHeader header = undrained_header();
  header.has_time = false;
  CollapseMonitor monitor(header);
  std::int64_t number = 0;
  for (const Row& row : rows) monitor.watch(state(number++, row));
  return monitor.finish();
}

const std::vector<Row> kFlow = {{0, 0, 100},   {0.1, 25, 92}, {0.3, 43, 82}, {0.8, 30, 55},
                                {1.5, 14, 28}, {2.5, 6, 11},  {4, 3, 6}};

}  // namespace

TEST_CASE("the largest strength, what was lost of it, and its second-order work") {
  const double sign = GENERATE(1.0, -1.0);
  const auto fall = fall_of(kFlow, sign);
  REQUIRE(fall);
  CHECK(fall->peak.reading == 2);
  CHECK(fall->loss() == Approx(1 - 3.0 / 43));
  CHECK(fall->readings == 1);
  CHECK(fall->confirmed);
  // dq dε_q over √(3 dp² + 2/3 dq²) √(3/2) dε_q, undrained
  const double dq = -40e3, dp = -76e3;
  CHECK(fall->normalised_work() ==
        Approx(dq / (std::sqrt(3 * dp * dp + dq * dq * 2 / 3) * std::sqrt(1.5))));
}

TEST_CASE("what unloads, stands or comes to nothing is no fall") {
  CHECK_FALSE(fall_of({{0, 0, 100}, {0.5, 40, 90}, {0.4, 20, 95}, {0.3, 0, 98}}));
  CHECK_FALSE(fall_of({{0, 0, 100}, {0.5, 40, 90}, {0.5, 30, 87}, {0.502, 28, 86}}));
  CHECK_FALSE(fall_of({{0, 0, 100}, {0.5, 40, 90}, {1, 38, 80}, {2, 41, 85}}));
  CHECK_FALSE(fall_of({{0, 0, 100}, {0.5, 0.4, 90}, {1, 0.1, 80}, {2, 0.2, 85}}));
}

TEST_CASE("after a loop of unloading the backbone begins anew: what the loop took is no fall") {
  std::vector<Row> rows = {{0, 0, 100},    {0.3, 43, 82},  {0.28, 20, 85}, {0.2, 2, 88},
                           {0.25, 20, 75}, {0.31, 30, 60}, {0.6, 41, 55}};
  CHECK_FALSE(fall_of(rows));
  rows.insert(rows.end(), {{1.2, 20, 30}, {2, 8, 14}});
  const auto fall = fall_of(rows);
  REQUIRE(fall);
  CHECK(fall->peak.reading == 6);
  CHECK(fall->loss() == Approx(1 - 8.0 / 41));
}

TEST_CASE("what comes back is known") {
  const auto fall =
      fall_of({{0, 0, 100}, {0.3, 43, 82}, {0.8, 30, 55}, {1.5, 25, 50}, {3, 40, 60}});
  REQUIRE(fall);
  CHECK(fall->share_regained() == Approx(15.0 / 18));
}

TEST_CASE("noise alone is no fall, nor a softening within it, however many states there are") {
  const double rms = GENERATE(0.5, 1.0, 2.0);  // kPa, of 50
  const int count = GENERATE(60, 1000, 5000);
  const auto seed = static_cast<std::uint64_t>(GENERATE(range(1, 11)));
  std::mt19937_64 rng(seed);
  std::normal_distribution<double> noise(0, rms);
  std::vector<Row> rows;
  for (int i = 0; i < count; ++i) {
    const double x = i / (0.2 * count);
    const double q = 50 * (1 - std::exp(-5 * x)) * (1 - 0.01 * x);
    rows.push_back({5.0 * i / count, q + noise(rng), 100});
  }
  INFO(rms << " kPa, " << count << " states, seed " << seed);
  CHECK_FALSE(fall_of(rows));
}

TEST_CASE("steps of the strain that are finer than what counts as one add up") {
  std::vector<Row> rows;
  for (int i = 0; i < 4000; ++i)  // 4e-4 % a state; q is lost within 20 states
    rows.push_back({4e-4 * i + (i > 3000 ? 0.1 : 0),
                    i < 2990 ? 40 : std::max(5.0, 40 - 2.0 * (i - 2990)), 80});
  const auto fall = fall_of(rows);
  REQUIRE(fall);
  CHECK(fall->loss() == Approx(1 - 5.0 / 40));
}

TEST_CASE("a record may begin at its peak") {
  CHECK(fall_of({{0, 60, 100}, {1, 20, 40}, {2, 19.5, 38}, {3, 19.2, 37}}));
}

TEST_CASE("the next specimen of a multistage test is no fall of the one before") {
  const std::vector<Row> first = {{0, 0, 100}, {1, 60, 90}, {2, 90, 95}, {4, 120, 100}};
  const std::vector<Row> second = {{4.05, 10, 200}, {4.2, 40, 195}, {5, 120, 180}, {8, 230, 190}};
  Backbone backbone;
  std::int64_t number = 0;
  backbone.start_stage(false);
  for (const Row& row : first) backbone.add(state(number++, row));
  backbone.start_stage(false);
  for (const Row& row : second) backbone.add(state(number++, row));
  CHECK_FALSE(backbone.worst());
}

TEST_CASE("one state without its strength is an outlier, unless the strain leapt with it") {
  const std::vector<Row> before = {{0, 0, 100}, {0.2, 40, 90}, {0.3, 50, 85}, {0.4, 55, 82}};
  auto rows = before;
  rows.insert(rows.end(), {{0.5, 5, 80}, {0.6, 56, 80}});
  CHECK_FALSE(fall_of(rows));
  rows = before;
  rows.push_back({0.5, 5, 20});
  REQUIRE(fall_of(rows));
  CHECK_FALSE(fall_of(rows)->confirmed);
  rows = before;
  rows.push_back({6, 5, 20});
  REQUIRE(fall_of(rows));
  CHECK(fall_of(rows)->confirmed);
}

TEST_CASE("seven rows of a flow are a flow, at the peak, and an onset between rows") {
  const Collapse c = verdict_on(kFlow);
  CHECK(c.judged);
  CHECK(c.kind == CollapseKind::flow);
  REQUIRE(c.onset);
  CHECK(c.onset->reading == 2);
  CHECK(*c.second_order_work_normalised < -0.2);
  CHECK(c.criteria.front().found());
}

TEST_CASE("fewer rows than a window are judged where they show the fall") {
  const Collapse c = verdict_on({{0, 0, 100}, {0.3, 43, 82}, {1.5, 14, 28}, {2.5, 6, 11}});
  CHECK(c.kind == CollapseKind::flow);
}

TEST_CASE("one row without its strength, the last of the record, is no proof and no all-clear") {
  std::vector<Row> rows = kFlow;
  rows.resize(3);
  rows.insert(rows.begin() + 1, {{0.02, 6, 99}, {0.04, 11, 97}, {0.06, 16, 95}, {0.08, 21, 94}});
  rows.push_back({0.8, 30, 55});
  const Collapse c = verdict_on(rows);
  CHECK_FALSE(c.judged);
  CHECK(c.judged_until == 6);
  CHECK(c.judged_until_reason.find("q fell by 30 %") != std::string::npos);
}

TEST_CASE("a fall after a long creep at slowly falling q is seen: what was long ago is forgotten") {
  std::vector<Row> rows;
  for (int i = 0; i <= 400; ++i) rows.push_back({0.002 * i, 55 - 0.02 * i, 84 - 0.04 * i});
  rows.insert(rows.end(), {{16.8, 4.6, 1.8}, {16.86, 4.7, 2.2}});
  const auto fall = fall_of(rows);
  REQUIRE(fall);
  CHECK(fall->last_high.reading == 400);
  CHECK(fall->confirmed);
}

TEST_CASE(
    "a fall to nothing after a loop between few readings is a fall: the loop's bends are no "
    "noise") {
  const std::vector<Row> rows = {
      {0, 1, 149},     {0.1, 17, 138},  {0.22, 42, 125}, {0.31, 31, 107}, {0.18, 20, 93},
      {0.7, 40, 57},   {1.25, 30, 33},  {1.65, 22, 22},  {2.1, 16, 15},   {2.65, 10, 9},
      {3.3, 5, 5},     {3.8, 2, 2.6},   {4.5, 1.5, 1.4}, {5.1, 0.6, 0.8}, {5.7, 0.3, 0.7},
      {6.3, 0.4, 0.7}, {6.9, 0.3, 0.8}, {7.5, 0.3, 0.7}, {8.1, 0.2, 0.7}, {8.7, 0.1, 0.8}};
  const auto fall = fall_of(rows);
  REQUIRE(fall);
  CHECK(fall->peak.q == Approx(40e3));
  CHECK(fall->loss() > 0.9);
  const Collapse verdict = verdict_on(rows);
  CHECK(verdict.kind == CollapseKind::flow);
}

TEST_CASE("what the first reading of an unloading took is no fall: the strain goes back after it") {
  const std::vector<Row> rows = {
      {0, 2, 144},     {0.1, 34, 136},  {0.29, 56, 117},  {0.49, 58, 101}, {0.38, 30, 91},
      {0.26, 18, 76},  {0.5, 40, 62},   {1.09, 50, 50},   {1.7, 63, 54},   {1.95, 56, 55},
      {1.85, 33, 40},  {1.93, 29, 27},  {2.46, 46, 35},   {2.89, 64, 48},  {3.28, 84, 61},
      {3.62, 105, 76}, {3.94, 126, 90}, {4.27, 149, 107}, {4.53, 170, 121}};
  CHECK_FALSE(fall_of(rows));
}

namespace {

/// 200 states up to 77 kPa in steps of 0.00425 %, then `count` states at 4 kPa in steps of `step` %
/// of which the first is the lowest.
std::vector<Row> sudden_fall(double step, int count) {
  std::vector<Row> rows;
  for (int i = 0; i < 200; ++i) {
    const double left = 1 - i / 200.0;
    rows.push_back({0.00425 * i, 77 * (1 - left * left), 200 - 0.4 * i});
  }
  for (int i = 0; i < count; ++i) rows.push_back({0.84575 + step * (i + 1), i == 0 ? 3.8 : 3.9, 2});
  return rows;
}

}  // namespace

TEST_CASE("Backbone: a fall within one reading counts whatever the strain step") {
  const double step = GENERATE(0.0025, 0.00425, 0.007, 0.1);
  const int count = GENERATE(3, 12, 100);
  const auto fall = fall_of(sudden_fall(step, count));
  REQUIRE(fall);
  CHECK(fall->confirmed);
  CHECK(fall->loss() > 0.94);
  CHECK(verdict_on(sudden_fall(step, count)).kind == CollapseKind::flow);
}

TEST_CASE("Backbone: a small step counts once the strain has gone on far enough") {
  CHECK_FALSE(fall_of(sudden_fall(0.0012, 12)));  // slower than before, and by 0.01 % only
  CHECK(fall_of(sudden_fall(0.0012, 60)));
}

TEST_CASE("Backbone: what is lost after the drive has stopped is no fall") {
  CHECK_FALSE(fall_of(sudden_fall(0, 100)));
  CHECK_FALSE(fall_of(sudden_fall(1e-5, 100)));
}
