// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/dialect_writer.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/records/dialect.hpp"

using namespace triax;
using namespace triax::study;

namespace {

WrittenDialect small_dialect() {
  return {.name = "site A",
          .encoding = "UTF-8",
          .separator = "semicolon",
          .decimal = ",",
          .columns = {{.quantity = "axial_strain", .position = 2, .unit = "%"},
                      {.quantity = "back_volume", .position = 5, .unit = "cm3", .sign = -1},
                      {.quantity = "time",
                       .position = 1,
                       .date_order = lab::DateOrder::day_first,
                       .remark = "name"}},
          .constants = {{.quantity = "cell_pressure", .value = 312.5, .unit = "kPa"}}};
}

}  // namespace

TEST_CASE("write_dialect: parse_dialect reads all of it back", "[intake]") {
  const lab::Dialect read = lab::parse_dialect(write_dialect(small_dialect()), "d");
  CHECK(read.name == "site A");
  CHECK(read.separator == lab::Separator::semicolon);
  CHECK(read.decimal == lab::DecimalMark::comma);
  REQUIRE(read.columns.size() == 3);
  CHECK(read.columns[0].position == 2);
  CHECK(read.columns[1].sign == -1);
  CHECK(read.columns[1].unit == "cm3");
  CHECK(read.columns[2].date_order == lab::DateOrder::day_first);
  REQUIRE(read.constants.size() == 1);
  CHECK(read.constants[0].si == Approx(312'500));
}

TEST_CASE("write_dialect: texts of a file or a user cannot become keys", "[intake]") {
  const std::string evil = "x\"\n[specimen]\nheight_mm = \"H\"\r\n# \x01 = {{";
  WrittenDialect dialect = small_dialect();
  dialect.name = evil;
  dialect.remark = evil;
  dialect.remarks = {evil, "\n[test]\nname = \"n\""};
  dialect.columns[0].remark = evil;
  dialect.columns[1].is_commented = true;
  dialect.columns[1].unit = evil;
  const lab::Dialect read = lab::parse_dialect(write_dialect(dialect), "d");
  CHECK(read.name == evil);
  CHECK(read.keys.empty());
  CHECK(read.columns.size() == 2);
  for (const char* quantity : {"", "a = 1\nb", "[columns]", "\"q\"", "Axial"}) {
    dialect = small_dialect();
    dialect.columns[0].quantity = quantity;
    CHECK_THROWS_AS(write_dialect(dialect), lab::BadInput);
    dialect = small_dialect();
    dialect.constants[0].quantity = quantity;
    CHECK_THROWS_AS(write_dialect(dialect), lab::BadInput);
  }
}

TEST_CASE("write_dialect: a quantity is in one column", "[intake]") {
  WrittenDialect dialect = small_dialect();
  dialect.columns[1].quantity = "axial_strain";
  CHECK_THROWS_WITH(write_dialect(dialect), Catch::Contains("columns 2 and 5"));
  dialect.columns[1].is_commented = true;
  CHECK_NOTHROW(write_dialect(dialect));
  dialect.constants[0].quantity = "axial_strain";
  CHECK_THROWS_WITH(write_dialect(dialect), Catch::Contains("a column and a value"));
}
