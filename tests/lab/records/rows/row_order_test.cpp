// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/row_order.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;
using enum Quantity;

namespace {

Row row_at(double strain, double q, double time_s = kMissing) {
  Row row;
  row.si.fill(kMissing);
  row.si[index(axial_strain)] = strain;
  row.si[index(deviator_stress)] = q;
  row.time_s = time_s;
  return row;
}

std::vector<Row> shear(double sign = 1, bool has_time = false) {
  std::vector<Row> rows;
  for (int i = 0; i < 40; ++i)
    rows.push_back(row_at(sign * 0.002 * i, sign * 100 * i / (i + 9.0), has_time ? i : kMissing));
  return rows;
}

/// What RowOrder says; the first row is in line 2.
std::string fault(std::vector<Row> rows) {
  std::vector<Warning> warnings;
  Findings findings(warnings);
  RowOrder order("m.csv");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].line = static_cast<std::int64_t>(i) + 2;
    order.add(rows[i], i == 0, findings);
  }
  try {
    order.finish();
  } catch (const BadInput& error) {
    return error.what();
  }
  return warnings.empty() ? "" : std::to_string(warnings[0].line) + ": " + warnings[0].text;
}

}  // namespace

TEST_CASE("RowOrder: rows in their order raise nothing") {
  CHECK(fault(shear()).empty());
  CHECK(fault(shear(-1)).empty());
  CHECK(fault(shear(1, true)).empty());
}

TEST_CASE("RowOrder: rows in reverse order are an error by time") {
  auto rows = shear(1, true);
  std::ranges::reverse(rows);
  CHECK_THAT(fault(rows), Catch::StartsWith("m.csv:2: the rows are in reverse order: the time "
                                            "decreases from 39 s in this line to 0 s in line 41"));
}

TEST_CASE("RowOrder: without time, a strain that runs back to zero is reversed") {
  for (const double sign : {1.0, -1.0}) {
    auto rows = shear(sign);
    std::ranges::reverse(rows);
    CHECK_THAT(
        fault(rows),
        Catch::StartsWith("m.csv:2: the rows are in reverse order: the axial strain decreases") &&
            Catch::Contains(" % of that value in line "));
  }
}

TEST_CASE("RowOrder: a specimen that is unloaded is in order") {
  std::vector<Row> rows;
  for (int i = 0; i < 40; ++i) rows.push_back(row_at(0.05 - 0.0002 * i, 100 - 2 * i));
  CHECK(fault(rows).empty());
  auto timed = shear();
  std::ranges::reverse(timed);
  for (std::size_t i = 0; i < timed.size(); ++i) timed[i].time_s = static_cast<double>(i);
  CHECK(fault(timed).empty());
}

TEST_CASE("RowOrder: two rows that changed places are noted without time") {
  auto rows = shear();
  std::swap(rows[20], rows[21]);
  CHECK_THAT(fault(rows),
             Catch::StartsWith("23: this row and the previous row seem to be swapped"));
}

TEST_CASE("RowOrder: two rows that changed places are noted beside a noisy load") {
  auto rows = shear();
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i].si[index(deviator_stress)] += 0.5 * std::sin(9.0 * static_cast<double>(i * i));
  CHECK(fault(rows).empty());
  std::swap(rows[20], rows[21]);
  CHECK_THAT(fault(rows),
             Catch::StartsWith("23: this row and the previous row seem to be swapped"));
}

TEST_CASE("RowOrder: blocks of rows that changed places are noted without time") {
  auto rows = shear();
  std::rotate(rows.begin() + 10, rows.begin() + 18, rows.begin() + 27);
  CHECK_THAT(fault(rows), Catch::Contains("the axial strain decreases only in this row"));
}

TEST_CASE("RowOrder: one row of unloading is in its place") {
  auto rows = shear();
  rows.insert(rows.begin() + 20, row_at(0.036, 10));
  CHECK(fault(rows).empty());
}

TEST_CASE("RowOrder: noise of the strain is no order") {
  std::vector<Row> rows;
  for (int i = 0; i < 300; ++i)
    rows.push_back(row_at(0.001 * i + 0.0008 * std::sin(7.0 * i * i), 0.3 * i));
  CHECK(fault(rows).empty());
}
