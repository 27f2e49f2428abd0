// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/plain_statement.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax;

TEST_CASE("a plain statement runs again with other values and keeps NULL apart from 0") {
  SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database.exec("CREATE TABLE t (a INTEGER UNIQUE, b REAL, c REAL) STRICT");
  db::PlainStatement insert(database, "INSERT INTO t VALUES (?,?,?)");
  for (std::int64_t i = 0; i < 3; ++i) {
    insert.bind(1, i);
    insert.bind(2, i == 1 ? std::nan("") : 0.5 * static_cast<double>(i));
    insert.bind_null(3);
    insert.run();
  }
  db::PlainStatement select(database, "SELECT a, b, c FROM t ORDER BY a");
  REQUIRE(select.step());
  CHECK(select.number(1) == 0);
  CHECK(select.is_null(2));
  REQUIRE(select.step());
  CHECK(select.integer(0) == 1);
  CHECK(std::isnan(select.number(1)));
  REQUIRE(select.step());
  CHECK_FALSE(select.step());

  insert.bind(1, std::int64_t{2});
  CHECK_THROWS_AS(insert.run(), SQLite::Exception);
  insert.bind(1, std::int64_t{3});
  CHECK_NOTHROW(insert.run());
  CHECK_THROWS_AS(db::PlainStatement(database, "SELECT no_such_column FROM t"), SQLite::Exception);
}
