// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/test_restart.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;
using enum Quantity;

namespace {

/// Rows of a record, and what TestRestart says of them.
class Rows {
 public:
  Row& add(double strain, double q, double p = 100, double time_s = kMissing) {
    Row row;
    row.si.fill(kMissing);
    row.si[index(axial_strain)] = strain;
    row.si[index(deviator_stress)] = q;
    row.si[index(mean_effective_stress)] = p;
    row.time_s = time_s;
    row.line = static_cast<std::int64_t>(rows_.size()) + 2;
    return rows_.emplace_back(row);
  }
  /// Undrained compression to 20 % in 40 rows; `time_s` of its first row.
  void add_test(double p0 = 100, double time_s = kMissing, double q0 = 0) {
    for (int i = 0; i <= 40; ++i)
      add(0.005 * i, q0 + 2 * p0 * i / (i + 8.0), p0 * (1 - 0.01 * i), time_s + 10 * i);
  }
  std::string fault(int new_stage_at = -1) {
    std::vector<Warning> warnings;
    Findings findings(warnings);
    TestRestart restart("m.csv");
    try {
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        Row row = rows_[i];
        if (new_stage_at > 0) row.stage = static_cast<int>(i) < new_stage_at ? 1 : 2;
        restart.add(row);
      }
      restart.finish(findings);
    } catch (const BadInput& error) {
      return error.what();
    }
    return warnings.empty() ? "" : "warning: " + warnings[0].text;
  }

 private:
  std::vector<Row> rows_;
};

const std::string kSecond = "m.csv:43: a second test begins with reading 41: ";

}  // namespace

TEST_CASE("TestRestart: a second test names its first reading and its line") {
  Rows rows;
  rows.add_test(100, 0);
  rows.add_test(100, 0);
  CHECK_THAT(rows.fault(),
             Catch::StartsWith(kSecond + "between line 42 and line 43 axial_strain decreases from "
                                         "0.2 to 0, and time_s from 400 to 0"));
}

TEST_CASE("TestRestart: found without time, and where the time goes on") {
  for (const double time : {kMissing, 410.0}) {
    Rows rows;
    rows.add_test(100, std::isnan(time) ? kMissing : 0);
    rows.add_test(100, time);
    CHECK_THAT(rows.fault(), Catch::StartsWith(kSecond));
  }
}

TEST_CASE("TestRestart: a second test at another pressure is found") {
  Rows rows;
  rows.add_test(100);
  rows.add_test(300);
  rows.add_test(500);
  CHECK_THAT(rows.fault(), Catch::StartsWith(kSecond));
}

TEST_CASE("TestRestart: a second test with its own q is found by the time") {
  Rows rows;
  rows.add_test(100, 0);
  rows.add_test(100, 0, 80);
  CHECK_THAT(rows.fault(), Catch::StartsWith(kSecond));
}

TEST_CASE("TestRestart: a second cyclic test is found by its effective stress") {
  const auto add_cycles = [](Rows& rows) {
    for (int i = 0; i <= 80; ++i) {
      const double phase = std::numbers::pi * i / 10;
      rows.add(0.0005 * i * std::sin(phase), 30 * std::sin(phase), 100 - i);
    }
  };
  Rows one, two;
  add_cycles(one);
  CHECK(one.fault().empty());
  add_cycles(two);
  add_cycles(two);
  CHECK_THAT(two.fault(), Catch::Contains("a second test begins with reading 81"));
}

TEST_CASE("TestRestart: unloading to zero strain is the same test") {
  Rows cycles;
  for (int i = 0; i <= 200; ++i) {
    const double load = std::sin(std::numbers::pi * i / 5);
    cycles.add(0.01 * load * load, 50 * load * load, 100 - 0.2 * i, 10.0 * i);
  }
  CHECK(cycles.fault().empty());
  Rows unloaded;
  unloaded.add_test(100, 0);
  for (int i = 39; i >= 0; --i) unloaded.add(0.005 * i, 2.0 * i - 20, 60, 800 - 10 * i);
  CHECK(unloaded.fault().empty());
}

TEST_CASE("TestRestart: cells that fell out are no second test") {
  Rows rows;
  for (int i = 0; i <= 60; ++i) {
    const bool out = i == 30 || i == 31;
    rows.add(out ? 0 : 0.005 * i, out ? 0 : 2.0 * i, 100 - i, out && i == 30 ? 0 : 10.0 * i);
  }
  CHECK(rows.fault().empty());
}

TEST_CASE("TestRestart: a clock that runs back alone is no second test") {
  Rows rows;
  for (int i = 0; i <= 60; ++i) rows.add(0.005 * i, 2.0 * i, 100 - i, i < 30 ? 10 * i : i - 30);
  CHECK(rows.fault().empty());
}

TEST_CASE("TestRestart: a new stage may begin with a counter set to zero") {
  Rows rows;
  rows.add_test(100, 0);
  rows.add_test(100, 410);
  CHECK(rows.fault(41).empty());
  CHECK_FALSE(rows.fault().empty());
}

TEST_CASE("TestRestart: a return to the start in the last rows is a warning") {
  Rows rows;
  rows.add_test(100, 0);
  rows.add(0, 0, 100, 410);
  CHECK_THAT(rows.fault(), Catch::StartsWith("warning: it seems that a second test begins with "
                                             "reading 41"));
}
