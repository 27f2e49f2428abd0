// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/schema/schema_text.hpp"

#include <catch2/catch.hpp>

using namespace triax;

TEST_CASE("is_same_definition: blanks, comments and quotes of names do not count") {
  CHECK(db::is_same_definition("CREATE VIEW v AS SELECT a /* first */ FROM t",
                               "CREATE VIEW \"v\" AS\n SELECT a FROM t -- all"));
  CHECK_FALSE(db::is_same_definition("CREATE VIEW v AS SELECT a FROM t",
                                     "CREATE VIEW v AS SELECT b FROM t"));
  CHECK_FALSE(db::is_same_definition("CREATE VIEW v AS SELECT '--' FROM t",
                                     "CREATE VIEW v AS SELECT '' FROM t"));
}

TEST_CASE("is_same_definition: a quoted name of several words stays one") {
  CHECK_FALSE(db::is_same_definition("CREATE TABLE t (\"id INTEGER PRIMARY KEY\", b CHECK (b))",
                                     "CREATE TABLE t (id INTEGER PRIMARY KEY, b CHECK (b))"));
}

TEST_CASE("is_same_definition: columns of a name and a type may differ") {
  const std::string_view table = "CREATE TABLE t (id INTEGER PRIMARY KEY, a REAL) STRICT";
  CHECK(db::is_same_definition(table,
                               "CREATE TABLE t (id INTEGER PRIMARY KEY, b TEXT, a REAL, "
                               "c INTEGER) STRICT"));
  for (const char* other :
       {"CREATE TABLE t (id INTEGER PRIMARY KEY, a REAL)",
        "CREATE TABLE t (id INTEGER, a REAL) STRICT",
        "CREATE TABLE t (id INTEGER PRIMARY KEY, a REAL DEFAULT 1) STRICT",
        "CREATE TABLE t (id INTEGER PRIMARY KEY, a REAL CHECK (a > 0)) STRICT",
        "CREATE TABLE t (id INTEGER PRIMARY KEY, a REAL, b REAL AS (a + 1)) STRICT",
        "CREATE TABLE t (id INTEGER PRIMARY KEY, a REAL, b UNIQUE) STRICT"})
    CHECK_FALSE(db::is_same_definition(table, other));
}

TEST_CASE("is_ordinary_table: not a virtual table") {
  CHECK(db::is_ordinary_table("CREATE TABLE t (a)"));
  CHECK_FALSE(db::is_ordinary_table("CREATE VIRTUAL TABLE t USING fts5(a)"));
}

TEST_CASE("is_plain_index: columns as they are, of all rows, not unique") {
  CHECK(db::is_plain_index("CREATE INDEX i ON scans (q_Pa, stage DESC)"));
  CHECK_FALSE(db::is_plain_index("CREATE UNIQUE INDEX i ON scans (q_Pa)"));
  CHECK_FALSE(db::is_plain_index("CREATE INDEX i ON scans (abs(q_Pa))"));
  CHECK_FALSE(db::is_plain_index("CREATE INDEX i ON scans (q_Pa) WHERE stage = 1"));
}
