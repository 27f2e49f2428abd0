// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/cells/cells.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <charconv>
#include <cstring>
#include <random>

using namespace triax::lab;

namespace {
std::vector<std::string> split(std::string_view line, Separator separator) {
  std::vector<std::string_view> cells;
  split_cells(line, separator, cells);
  return {cells.begin(), cells.end()};
}
struct Parsed {
  CellKind kind;
  double value = 0;
  DecimalMark mark = DecimalMark::open;
};
Parsed parse(std::string_view cell, DecimalMark mark = DecimalMark::open) {
  Parsed out{CellKind::text, 0, mark};
  out.kind = parse_cell(cell, out.mark, out.value);
  return out;
}
}  // namespace

TEST_CASE("cells are split by each separator") {
  using Cells = std::vector<std::string>;
  CHECK(split("a,b , c", Separator::comma) == Cells{"a", "b", "c"});
  CHECK(split("a;;", Separator::semicolon) == Cells{"a", "", ""});
  CHECK(split("\"0,5\",\"x\"", Separator::comma) == Cells{"0,5", "x"});
  CHECK(split("a\t b\t", Separator::tab) == Cells{"a", "b", ""});
  CHECK(split("  1   2\t3 ", Separator::blanks) == Cells{"1", "2", "3"});
  CHECK(split("eps1   Void ratio  eta = q/p\tp", Separator::wide_blanks) ==
        Cells{"eps1", "Void ratio", "eta = q/p", "p"});
  CHECK(split("", Separator::comma) == Cells{""});
  CHECK(split("", Separator::blanks).empty());
}

TEST_CASE("parse_cell: a cell is a number, missing, out of range or text") {
  CHECK(parse("12.5").value == 12.5);
  CHECK(parse("5.99205e+002").value == 599.205);
  CHECK(parse("-.15000000000E-03").value == -0.15e-3);
  CHECK(parse("+3").value == 3);
  for (const char* word :
       {"", "-", "NaN", "nan", "#DIV/0!", "#N/A", "n/a", "null", "inf", "OVLD", "1.#QNAN", "<0.5"})
    CHECK(parse(word).kind == CellKind::missing);
  for (const char* word :
       {"abc", "1.2.3", "12 kPa", "1e", "0x10", "1,234.5", "1,2,3", "1.234,5", "1e5.5", "5-"})
    CHECK(parse(word).kind == CellKind::text);
  CHECK(parse("1e999").kind == CellKind::out_of_range);
}

TEST_CASE("parse_cell: a number with two signs is text") {
  for (const char* word : {"+-5", "--5", "-+5", "++5", "+-.5", "- 5", "+", "+-inf"})
    CHECK(parse(word).kind == CellKind::text);
}

TEST_CASE("parse_cell: a number too small for a double is not 0") {
  for (const char* word : {"1e-400", "-3.5E-999", "+1e-400"})
    CHECK(parse(word).kind == CellKind::out_of_range);
  CHECK(parse("0e-400").value == 0);
  CHECK(parse("1e-300").value == 1e-300);
}

TEST_CASE("the first decimal mark decides, the other one is then no number") {
  const auto comma = parse("0,5");
  CHECK(comma.value == 0.5);
  CHECK(comma.mark == DecimalMark::comma);
  CHECK(parse("0.5").mark == DecimalMark::point);
  CHECK(parse("7").mark == DecimalMark::open);
  CHECK(parse("1.234", DecimalMark::comma).kind == CellKind::text);
  CHECK(parse("1,234", DecimalMark::point).kind == CellKind::text);
}

TEST_CASE("the short way gives the bits of the library's way, or declines") {
  std::mt19937_64 random(7);
  int taken = 0;
  for (int i = 0; i < 200'000; ++i) {
    std::array<char, 64> text{};
    const auto digits = static_cast<int>(random() % 8);
    const double value =
        (static_cast<double>(random() % 2'000'000'000) - 1e9) / (i % 3 ? 1e4 : 7.3);
    const int size = std::snprintf(text.data(), text.size(), "%.*f", digits, value);
    double expected = 0;
    std::from_chars(text.data(), text.data() + size, expected);
    const char* at = text.data();
    double found = 0;
    if (!parse_plain(at, text.data() + size, found)) continue;
    ++taken;
    REQUIRE(at == text.data() + size);
    REQUIRE(std::memcmp(&found, &expected, sizeof found) == 0);
  }
  CHECK(taken > 100'000);
  for (const std::string_view word : {"", "-", ".", "abc", "12345678901234567890", "--1"}) {
    const char* at = word.data();
    double found = 0;
    CHECK_FALSE(parse_plain(at, word.data() + word.size(), found));
    CHECK(at == word.data());
  }
}
