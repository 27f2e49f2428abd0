// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/phrase_table.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("PhraseTable: the longest phrase of a number counts and comes first") {
  PhraseTable table;
  table.add({"pore"}, 1);
  table.add({"pore", "pressure"}, 2);
  table.add({"excess", "pore", "pressure"}, 1);
  const auto matches = table.find({"the", "excess", "pore", "pressure"});
  REQUIRE(matches.size() == 2);
  CHECK(matches[0].number == 1);
  CHECK(matches[0].length == 18);
  CHECK(matches[1].number == 2);
  CHECK(table.find({"porepressure"}).empty());
  CHECK(table.find({}).empty());
}

TEST_CASE("PhraseTable: an East Asian phrase is found inside a token") {
  PhraseTable table;
  table.add({QString::fromUtf8("围压")}, 3);
  CHECK(table.find({QString::fromUtf8("有效围压值")}).size() == 1);
  CHECK(table.find({QString::fromUtf8("围")}).empty());
}
