// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/restart_finder.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

/// Rows of a table, and the readings with which RestartFinder begins another test.
class Table {
 public:
  void add(double strain, double load, double time, bool begins_stage = false) {
    rows_.push_back({{strain, load, NAN, NAN, time}, begins_stage});
  }
  /// Compression to 10 % in 20 steps of 10 s.
  void add_test(double begin_s, std::size_t first_row = 0) {
    for (std::size_t i = first_row; i <= 20; ++i) {
      const auto x = static_cast<double>(i);
      add(0.005 * x, 100 * x / (x + 2), begin_s + 10 * x);
    }
  }
  std::vector<std::int64_t> restarts() const {
    RestartFinder finder;
    std::vector<std::int64_t> out;
    std::int64_t line = 2;
    for (const auto& [state, begins_stage] : rows_)
      if (const auto found = finder.add(state, line++, begins_stage)) {
        CHECK(found->line == found->reading + 2);
        out.push_back(found->reading);
      }
    return out;
  }

 private:
  std::vector<std::pair<RowState, bool>> rows_;
};

using Readings = std::vector<std::int64_t>;

}  // namespace

TEST_CASE("RestartFinder: finds each of several tests, with the clock or without") {
  for (const double pause_s : {-210.0, 600.0, static_cast<double>(NAN)}) {
    Table table;
    for (int test = 0; test < 3; ++test) table.add_test(test * (200 + pause_s));
    CHECK(table.restarts() == Readings{21, 42});
  }
}

TEST_CASE("RestartFinder: a test may lack its first readings") {
  Table table;
  table.add(NAN, NAN, 0);
  table.add_test(0, 2);
  table.add_test(1000);
  CHECK(table.restarts() == Readings{20});
}

TEST_CASE("RestartFinder: a load that scatters about zero has returned") {
  Table table;
  table.add_test(0, 2);
  table.add(0, -0.2, 1000);
  table.add_test(1000, 1);
  CHECK(table.restarts() == Readings{19});
}

TEST_CASE("RestartFinder: the second test may have longer steps") {
  Table table;
  table.add_test(0);
  for (int i = 0; i <= 10; ++i) table.add(0.015 * i, 100.0 * i / (i + 1.0), 1000 + 10 * i);
  CHECK(table.restarts() == Readings{21});
}

TEST_CASE("RestartFinder: a cyclic test of few readings a cycle is one test") {
  for (const double readings : {5.0, 9.0, 10.0, 21.0}) {
    Table table;
    for (int i = 0; i < 120; ++i) {
      const double wave = std::sin(2 * std::numbers::pi * i / readings);
      table.add(1e-4 * (1 + 0.2 * i) * wave, 40 * wave, 10 * i);
    }
    CHECK(table.restarts().empty());
  }
}

TEST_CASE("RestartFinder: a strain that is set to zero before shear is one test") {
  Table table;
  for (int i = 0; i < 30; ++i) table.add(0.001 * i, i % 3 == 1 ? 0.1 : 0.0, 10 * i);
  for (int i = 0; i <= 20; ++i) table.add(0.005 * i, 100.0 * i / (i + 2.0), 300 + 10 * i);
  CHECK(table.restarts().empty());
}

TEST_CASE("RestartFinder: a new stage is no second test") {
  Table table;
  table.add_test(0);
  table.add(0, 0, 210, true);
  table.add_test(220, 1);
  CHECK(table.restarts().empty());
}

TEST_CASE("RestartFinder: a return without rows behind it is open") {
  RestartFinder finder;
  for (int i = 0; i <= 20; ++i) finder.add({0.005 * i, 5.0 * i, NAN, NAN, 10.0 * i}, i + 2, false);
  CHECK_FALSE(finder.open());
  CHECK_FALSE(finder.add({0, 0, NAN, NAN, 0}, 23, false));
  REQUIRE(finder.open());
  CHECK(finder.open()->line == 23);
  CHECK(finder.open()->line_before == 22);
}

TEST_CASE("RestartFinder: a step across a missing row is no jump") {
  Table table;
  for (int i = 0; i < 60; ++i) {
    const double phase = 2 * std::numbers::pi * i / 16;
    const bool is_missing = i == 39 || i == 15 || i == 31;  // just before strain and load are zero
    table.add(is_missing ? NAN : 0.02 * std::sin(phase), is_missing ? NAN : 10 * std::sin(phase),
              9.0 * i);
  }
  CHECK(table.restarts().empty());
}
