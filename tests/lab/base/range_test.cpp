// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/range.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

using namespace triax::lab;

namespace {

std::vector<std::string> values(const char* text) { return written_values(read_range(text, 1000)); }

using Values = std::vector<std::string>;

}  // namespace

TEST_CASE("a range by its step keeps its digits, and its end where a step meets it") {
  CHECK(values("1.0:1.06:0.02") == Values{"1.00", "1.02", "1.04", "1.06"});
  CHECK(values("1:4:1") == Values{"1", "2", "3", "4"});
  CHECK(values("3:1:-1") == Values{"3", "2", "1"});
  CHECK(values("1:2:0.4") == Values{"1.0", "1.4", "1.8"});
  CHECK(read_range("1:2:0.5", 10).meets_end());
  CHECK_FALSE(read_range("1:2:0.4", 10).meets_end());
}

TEST_CASE("a range by its count has both ends, to the bit") {
  const Range range = read_range("0.1:0.7/4", 10);
  CHECK(range.count == 4);
  CHECK(range.at(0) == 0.1);
  CHECK(range.at(3) == 0.7);
  CHECK(range.meets_end());
  CHECK(values("20:200/7") == Values{"20", "50", "80", "110", "140", "170", "200"});
  CHECK(values("1.0:1.2/3") == Values{"1", "1.1", "1.2"});
  CHECK(values("5:5/1") == Values{"5"});
  CHECK(read_range("300:10/3", 10).at(1) == Approx(155));
}

TEST_CASE("what is no range, leads away or is too long is told with the text") {
  for (const auto& [text, says] :
       {std::pair("1:2", "FROM:TO:STEP or FROM:TO/COUNT"), std::pair("7", "FROM:TO:STEP"),
        std::pair("1:2:3:4", "FROM:TO:STEP"), std::pair("a:2:1", "FROM:TO:STEP"),
        std::pair("1:inf:1", "FROM:TO:STEP"), std::pair("1:2/x", "expected an integer"),
        std::pair("1:2/0", "expected an integer"), std::pair("1:2:0", "cannot reach"),
        std::pair("1:2:-1", "cannot reach"), std::pair("1:2/2000", "more than 1000"),
        std::pair("0:1:1e-6", "more than 1000")}) {
    INFO(text);
    CHECK_THROWS_AS(read_range(text, 1000), std::invalid_argument);
    CHECK_THROWS_WITH(read_range(text, 1000), Catch::Contains(text) && Catch::Contains(says));
  }
  CHECK(looks_like_range("1:2"));
  CHECK_FALSE(looks_like_range("0.6,0.7"));
}
