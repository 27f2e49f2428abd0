// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/rows_ahead.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/records/tables/table_recognition.hpp"

using namespace triax::lab;

namespace {

constexpr int kRowsInBlocks = 3000;  ///< some blocks

/// Of three columns; a cell is missing in some rows, and `end` stands behind the last.
std::string table(const std::string& end = "") {
  std::string text = "time_s,axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n";
  for (int i = 0; i < kRowsInBlocks; ++i)
    text += i % 700 == 650 ? fmt::format("{},{},,{}\n", i, 0.01 * i, 100 + i)
                           : fmt::format("{},{},{},{}\n", i, 0.01 * i, 0.3 * i, 100 + i);
  return text + end;
}

struct Read {
  std::vector<Warning> warnings;
  Findings findings{warnings};
  std::unique_ptr<ByteSource> source;
  TableLayout layout;
  std::vector<Row> rows;
  std::vector<std::size_t> told;  ///< warnings when a row came
  std::string failure;

  explicit Read(std::string text)
      : source(open_memory("m", std::move(text))), layout(recognise_table(*source, {}, findings)) {}

  template <class Reader>
  void all(Reader& reader) {
    Row row;
    try {
      while (reader.next(row)) {
        rows.push_back(row);
        told.push_back(warnings.size());
      }
    } catch (const BadInput& error) {
      failure = error.what();
    }
  }
  static Read alone(std::string text) {
    Read read(std::move(text));
    TableReader reader(*read.source, read.layout, read.findings);
    read.all(reader);
    read.findings.finish();
    return read;
  }
};

bool same(const Row& a, const Row& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return a.line == b.line && bits(a.time_s) == bits(b.time_s) &&
         std::ranges::equal(a.si, b.si, {}, bits, bits);
}

void check_same(const std::string& text) {
  const Read alone = Read::alone(text);
  Read ahead(text);
  {
    RowsAhead rows(*ahead.source, ahead.layout, ahead.findings, ahead.warnings);
    ahead.all(rows);
    ahead.findings.finish();
    rows.finish();
  }
  CHECK(std::ranges::equal(ahead.rows, alone.rows, same));
  CHECK(ahead.told == alone.told);
  CHECK(ahead.failure == alone.failure);
  CHECK(std::ranges::equal(ahead.warnings, alone.warnings, {}, &Warning::text, &Warning::text));
  CHECK(std::ranges::equal(ahead.warnings, alone.warnings, {}, &Warning::line, &Warning::line));
}

}  // namespace

TEST_CASE("rows read ahead, and what is found in them, are those of the reader alone",
          "[threads]") {
  const Read alone = Read::alone(table());
  REQUIRE(alone.rows.size() == kRowsInBlocks);
  REQUIRE(alone.told[600] < alone.told[700]);  // told at its row, not before
  check_same(table());
  check_same(table("\n\n3000,30,900,\n"));
  check_same(table("3000,30,900"));  // cut off
}

TEST_CASE("RowsAhead: an empty line before any row is found", "[threads]") {
  // Rows are read in blocks: an empty line before the first row of one is no other.
  for (const int row : {100, 512, 1024, 2048}) {
    std::string text = table();
    check_same(text.insert(text.find(fmt::format("\n{},", row)), "\n"));
  }
}

TEST_CASE("a failure comes behind the rows before it", "[threads]") {
  REQUIRE(Read::alone(table("3000,thirty,900,1\n")).failure.find("thirty") != std::string::npos);
  check_same(table("3000,thirty,900,1\n"));
  check_same(table("3000,30\n4000,40,1,1\n"));
}

TEST_CASE("reading ahead ends when nobody wants the rows", "[threads]") {
  Read ahead(table());
  RowsAhead rows(*ahead.source, ahead.layout, ahead.findings, ahead.warnings);
  Row row;
  REQUIRE(rows.next(row));
}
