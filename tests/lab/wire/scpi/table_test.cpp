// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/scpi/table.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "tests/lab/wire/scpi/asked.hpp"

using namespace triax::lab;
using triax::wire_tests::AskedDevice;

TEST_CASE("every row of a table is found by its short and its long form, and has help") {
  const AskedDevice asked;
  CHECK(asked.table.rows().size() > 25);
  std::vector<int> suffixes;
  for (const ScpiRow& row : asked.table.rows()) {
    INFO(row.pattern.text());
    CHECK(&asked.table.find(row.pattern.shortest(), suffixes) == &row);
    CHECK(&asked.table.find(row.pattern.longest(), suffixes) == &row);
    CHECK_FALSE(row.help.empty());
  }
}

TEST_CASE("a header for a point that the device does not have in that way is refused") {
  const AskedDevice asked;
  const ScpiHeader none[] = {{"flow_ml", "FLOW"}};
  CHECK_THROWS_AS(scpi_table_of(asked.device, none), BadInput);
  const ScpiHeader fixed[] = {{"pressure_kPa", "PRESsure", true, true}};
  CHECK_THROWS_WITH(scpi_table_of(asked.device, fixed),
                    "cell: pressure_kPa cannot be asked for and set");
}

TEST_CASE("values are said as SCPI says them") {
  CHECK(scpi_number(0.1) == "0.1");
  CHECK(scpi_number(-1234567.891) == "-1234567.891");
  CHECK(scpi_number(INFINITY) == "9.9E37");
  CHECK(scpi_number(-INFINITY) == "-9.9E37");
  CHECK(unit_of_point("target_kPa") == "kPa");
  CHECK(unit_of_point("valve") == "");
}
