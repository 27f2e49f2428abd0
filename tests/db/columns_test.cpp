// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/columns.hpp"

#include <SQLiteCpp/Database.h>

#include <catch2/catch.hpp>
#include <limits>

using namespace triax;

TEST_CASE("SI values pass through a column in units of the field, unknown ones through NULL") {
  SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database.exec(
      "CREATE TABLE t (a REAL, b REAL, c REAL, d INTEGER, e INTEGER, f TEXT, g TEXT) STRICT");
  SQLite::Statement insert(database, "INSERT INTO t VALUES (?,?,?,?,?,?,?)");
  const double pressure_pa = 500.12 * 1e3;
  for (int i = 0; i < 2; ++i)  // a statement can be used again
    db::Binder(insert)
        .si(pressure_pa, "kPa")
        .si(std::nullopt, "mm")
        .number(std::numeric_limits<double>::quiet_NaN())
        .integer(7)
        .integer(std::nullopt)
        .text("")
        .text_or_null("")
        .run();
  CHECK(database.execAndGet("SELECT count(*) FROM t").getInt() == 2);
  CHECK(database.execAndGet("SELECT a FROM t").getDouble() == 500.12);
  CHECK(database.execAndGet("SELECT f = '' AND g IS NULL FROM t").getInt() == 1);

  SQLite::Statement select(database, "SELECT * FROM t");
  REQUIRE(select.executeStep());
  db::Columns columns(select);
  CHECK(columns.si("kPa") == pressure_pa);
  CHECK_FALSE(columns.si("mm"));
  CHECK_FALSE(columns.number());
  CHECK(columns.truth() == true);
  CHECK_FALSE(columns.integer());
  CHECK(columns.text().empty());
  CHECK(columns.text().empty());
}
