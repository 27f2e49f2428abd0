// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/row_model.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {
RowModel rows_of(const std::string& text, Separator separator) {
  return fit_rows(read_sample(*open_memory("m", text)), separator);
}
}  // namespace

TEST_CASE("Row model: a comment mark is followed by text") {
  CHECK(comment_mark("# time", Separator::comma) == "#");
  CHECK(comment_mark("  // time", Separator::comma) == "//");
  CHECK(comment_mark("\"# time\",x", Separator::comma) == "#");
  CHECK(comment_mark("#;time", Separator::semicolon) == "#");
  CHECK(comment_mark("\"#\",\"kPa\"", Separator::comma) == "#");
  CHECK(comment_mark("; time", Separator::comma) == ";");
  CHECK(comment_mark("; time", Separator::semicolon).empty());
  CHECK(comment_mark("%\tkPa", Separator::tab).empty());
  CHECK(comment_mark("***End***", Separator::tab).empty());
  CHECK(comment_mark("", Separator::tab).empty());
}

TEST_CASE("Row model: numbers of columns are known") {
  CHECK(is_numbering("1;2;3;4", Separator::semicolon));
  CHECK(is_numbering("(1)\t(2)\t(3)\t(4)", Separator::tab));
  CHECK_FALSE(is_numbering("1;2;3", Separator::semicolon));
  CHECK_FALSE(is_numbering("1;2;3;5", Separator::semicolon));
}

TEST_CASE("Row model: rows, width and format of the right separator") {
  const auto rows = rows_of("t;q\n0,5;1\n1,5;-\n2,5;3\nMax;3\n", Separator::semicolon);
  CHECK(rows.width == 2);
  CHECK(rows.first == 1);
  CHECK(rows.last == 3);
  CHECK(rows.format.decimal == DecimalMark::comma);
  CHECK(rows.purity == 1);
  CHECK(rows.coverage == Approx(3.0 / 5));
  CHECK(rows.is_value_column(1));
}

TEST_CASE("Row model: a summary behind a blank line is no part of the rows") {
  const std::string rows = "s;t;q\nShear;0;1\nShear;1;2\nShear;2;3\nShear;3;4\nShear;4;5\n";
  CHECK(rows_of(rows + "\nMax;4;5\nShear;2;3\n", Separator::semicolon).last == 5);
  CHECK(rows_of(rows + "\nShear;5;6\nShear;6;7\n", Separator::semicolon).last == 8);
}

TEST_CASE("Row model: names of a summary below empty cells are no part of the rows") {
  const std::string rows = "x;t;q\n;0;1\n;1;2\n;2;3\n;3;4\n;4;5\n;5;6\n;6;7\n";
  CHECK(rows_of(rows + "Max;6;7\nMin;0;1\nMean;3;4\n", Separator::semicolon).last == 7);
}

TEST_CASE("Row model: a wrong separator explains less") {
  const std::string text = "t;q\n0,5;1\n1,5;2\n2,5;3\n";
  CHECK(rows_of(text, Separator::tab).width == 0);
  const auto rows = rows_of(text, Separator::comma);
  CHECK(rows.coverage * rows.purity < 0.5);
}

TEST_CASE("Row model: lines with one value are counted") {
  CHECK(rows_of("q\n1\n2\n", Separator::comma).single_values == 2);
}
