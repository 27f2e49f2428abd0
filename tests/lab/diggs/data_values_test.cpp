// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/diggs/data_values.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;

namespace {

DiggsResultSet set_of(const std::string& values, std::size_t columns) {
  DiggsResultSet set;
  set.line = 10;
  set.properties.resize(columns);
  set.values = values;
  return set;
}

using Cells = std::vector<std::string_view>;

}  // namespace

TEST_CASE("split_data_values: cells, empty cells and lines") {
  const auto set = set_of("\n  1,2,3\n4,,6 7,8,\n", 3);
  const auto tuples = split_data_values(set, "f");
  REQUIRE(tuples.size() == 3);
  CHECK(tuples[0].cells == Cells{"1", "2", "3"});
  CHECK(tuples[0].line == 11);
  CHECK(tuples[1].cells == Cells{"4", "", "6"});
  CHECK(tuples[1].line == 12);
  CHECK(tuples[2].cells == Cells{"7", "8", ""});
}

TEST_CASE("split_data_values: spaces after commas, other separators") {
  CHECK(split_data_values(set_of("1, 2, 3 4, 5, 6", 3), "f")[1].cells == Cells{"4", "5", "6"});
  auto set = set_of("1;2|3;4|", 2);
  set.cell_separator = ";";
  set.tuple_separator = "|";
  CHECK(split_data_values(set, "f").size() == 2);
  set = set_of("1 2 3\n4 5 6", 3);
  set.cell_separator = " ";
  CHECK(split_data_values(set, "f")[1].cells == Cells{"4", "5", "6"});
}

TEST_CASE("split_data_values: a wrong number of values names the line") {
  CHECK_THROWS_WITH(split_data_values(set_of("1,2\n3,4,5", 2), "f"),
                    "f:11: a tuple of dataValues has 3 values; the set has 2 properties");
  auto set = set_of("1 2 3", 2);
  set.cell_separator = " ";
  CHECK_THROWS_AS(split_data_values(set, "f"), BadInput);
  CHECK_THROWS_AS(split_data_values(set_of("1", 0), "f"), BadInput);
  CHECK(split_data_values(set_of(" \n", 2), "f").empty());
}
