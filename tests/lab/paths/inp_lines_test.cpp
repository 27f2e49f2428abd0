// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/inp_lines.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;
using Catch::Contains;

TEST_CASE("numbers are read as Fortran writes them") {
  CHECK(fortran_number("1") == 1.0);
  CHECK(fortran_number("-.15000000000E-03") == -0.15e-3);
  CHECK(fortran_number("+2.5d-1") == 0.25);
  CHECK(fortran_number("1D3") == 1000.0);
  CHECK(fortran_number("3.") == 3.0);
  for (const char* wrong : {"", "+", "++1", "+-1", "1.0x", "nan", "inf", "1e999", "1e61", "*End"})
    CHECK_FALSE(fortran_number(wrong));
}

TEST_CASE("a line gives its first numbers, whatever words follow; blank lines are passed over") {
  InpLines lines("\n  0.1, 2   lambda, kappa\r\n\n 7 nprops", "a.inp");
  CHECK(lines.numbers(2, "two") == std::vector<double>{0.1, 2});
  CHECK(lines.line_number() == 2);
  CHECK(lines.whole("a count", 1, 10) == 7);
  CHECK_FALSE(lines.next());
  CHECK_THROWS_WITH(lines.required("a step"), Contains("a.inp:4") && Contains("a step"));
}

TEST_CASE("what is no number, or no whole one, is named with its line") {
  InpLines words("1\nabc", "a.inp");
  words.next();
  CHECK_THROWS_WITH(words.numbers(1, "the stress"), Contains("a.inp:2: 'abc'"));
  InpLines few("1 2", "a.inp");
  CHECK_THROWS_AS(few.numbers(3, "three"), BadInput);
  InpLines part("1.5", "a.inp");
  CHECK_THROWS_WITH(part.whole("the count", 1, 9), Contains("the count is 1.5"));
  CHECK_THROWS_AS(InpLines(std::string("a\0b", 3), "a.inp"), BadInput);
}

TEST_CASE("comments end a line where their mark stands") {
  CHECK(inp_before("*End # that is all", "#!") == "*End");
  CHECK(inp_before("  *End", "#!") == "*End");
}
