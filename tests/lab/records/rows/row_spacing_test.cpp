// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/row_spacing.hpp"

#include <functional>

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

/// What RowSpacing says of the values; line 2 is the first.
std::vector<Warning> gaps(const std::vector<double>& values, int restart_at = -1) {
  std::vector<Warning> warnings;
  Findings findings(warnings);
  RowSpacing spacing("the time (s)");
  for (std::size_t i = 0; i < values.size(); ++i)
    spacing.add(values[i], static_cast<std::int64_t>(i) + 2, static_cast<int>(i) == restart_at,
                findings);
  findings.finish();
  return warnings;
}

std::vector<double> series(int count, const std::function<double(int)>& value) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(value(i));
  return values;
}

}  // namespace

TEST_CASE("RowSpacing: rows missing from an even series are counted with their line") {
  const auto found = gaps(series(40, [](int i) { return 10.0 * (i < 20 ? i : i + 2); }));
  REQUIRE(found.size() == 1);
  CHECK(found[0].line == 22);
  CHECK(found[0].text ==
        "2 rows are missing before this line: the time (s) goes from 190 to 220 in a series of "
        "equal steps of 10");
}

TEST_CASE("RowSpacing: every gap is counted") {
  const auto found = gaps(series(100, [](int i) { return 1.0 * (i + i / 25); }));
  REQUIRE(found.size() == 1);
  CHECK_THAT(found[0].text, Catch::StartsWith("1 row is missing") &&
                                Catch::EndsWith("(and 2 more, the last in line 77)"));
}

TEST_CASE("RowSpacing: a clock that is not quite even has no gap") {
  CHECK(gaps(series(200, [](int i) { return 10.0 * i + 0.04 * (i % 7); })).empty());
}

TEST_CASE("RowSpacing: a new interval or uneven steps are no gap") {
  CHECK(gaps(series(60, [](int i) { return i < 30 ? i : 30 + 2.0 * (i - 30); })).empty());
  CHECK(gaps(series(60, [](int i) { return 0.1 * i * i; })).empty());
  CHECK(gaps(series(60, [](int i) { return i + (i % 3) * 0.4; })).empty());
}

TEST_CASE("RowSpacing: a pause before a stage is no gap") {
  CHECK(gaps(series(40, [](int i) { return i < 20 ? i : i + 5.0; }), 20).empty());
}
