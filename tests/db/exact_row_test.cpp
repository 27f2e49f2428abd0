// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/exact_row.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace triax;

namespace {

struct Values {
  double a = 0, b = 0, c = 0, follows = 0;
  std::optional<double> d;
  std::int64_t count = 0;
  std::uint64_t seed = 0;
  bool yes = false;
  std::string word;
};

template <class Row, class V>
void visit(Row& row, V& v) {
  row("a_kPa", v.a, "kPa");
  row("word", v.word);
  row("b_pct", v.b, "%");
  row.follows("follows", v.follows);
  row("c", v.c);
  row("d_deg", v.d, "deg");
  row("count", v.count);
  row("seed", v.seed);
  row("yes", v.yes);
}

SQLite::Database table() {
  SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database.exec(
      "CREATE TABLE t (id INTEGER, a_kPa REAL, word TEXT, b_pct REAL, follows REAL, c REAL, "
      "d_deg REAL, count INTEGER, seed INTEGER, yes INTEGER, last_bits INTEGER)");
  return database;
}

std::vector<Values> all(SQLite::Database& database, std::int64_t id) {
  return db::select_rows<Values>(database, "t", {{"id", id}},
                                 [](auto& row, auto& v) { visit(row, v); });
}

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

TEST_CASE("numbers come back to the bit from columns in units of the field") {
  SQLite::Database database = table();
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> power(-12, 9);
  std::vector<Values> written = {{-0.0, -0.0, -0.0, 1, -0.0, 0, 0, false, ""}};
  for (int k = 0; k < 500; ++k) {
    const auto any = [&] { return mantissa(random) * std::pow(10, power(random)); };
    written.push_back({any(), any(), any(), any(), any(), k, random(), k % 2 == 0, "w"});
  }
  for (std::size_t k = 0; k < written.size(); ++k)
    db::insert_row(database, "t", {{"id", static_cast<std::int64_t>(k)}},
                   [&](auto& row) { visit(row, std::as_const(written[k])); });
  for (std::size_t k = 0; k < written.size(); ++k) {
    const auto read = all(database, static_cast<std::int64_t>(k));
    REQUIRE(read.size() == 1);
    INFO(k);
    CHECK(same(read[0].a, written[k].a));
    CHECK(same(read[0].b, written[k].b));
    CHECK(same(read[0].c, written[k].c));
    CHECK(same(*read[0].d, *written[k].d));
    CHECK(read[0].follows == Approx(written[k].follows));
    CHECK(read[0].count == written[k].count);
    CHECK(read[0].seed == written[k].seed);
    CHECK(read[0].yes == written[k].yes);
    CHECK(read[0].word == written[k].word);
  }
  CHECK(database.execAndGet("SELECT a_kPa FROM t WHERE id = 1").getDouble() ==
        Approx(written[1].a / 1e3).epsilon(1e-15));
}

TEST_CASE("what is not finite is NULL and comes back as not a number; a row of old has no bits") {
  SQLite::Database database = table();
  Values unknown;
  unknown.a = std::numeric_limits<double>::quiet_NaN();
  unknown.b = std::numeric_limits<double>::infinity();
  unknown.c = 3;
  db::insert_row(database, "t", {{"id", 1}},
                 [&](auto& row) { visit(row, std::as_const(unknown)); });
  database.exec("INSERT INTO t (id, a_kPa, b_pct) VALUES (2, 1.5, 2.5)");
  CHECK(database.execAndGet("SELECT a_kPa IS NULL AND b_pct IS NULL FROM t").getInt() == 1);
  const Values read = all(database, 1).at(0);
  CHECK(std::isnan(read.a));
  CHECK(std::isnan(read.b));
  CHECK(read.c == 3);
  CHECK_FALSE(read.d);
  const Values old = all(database, 2).at(0);
  CHECK(old.a == 1500);
  CHECK(old.b == Approx(0.025));
  CHECK(std::isnan(old.c));
  CHECK(old.count == 0);
}
