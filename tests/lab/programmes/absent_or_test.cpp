// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/absent_or.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/base/toml_reader.hpp"

using namespace triax::lab;

TEST_CASE("a number is 0 or within its bounds, or not there") {
  const auto table = TomlTable::parse(
      "zero = 0\nlow = 0.1\nhigh = 5\nless = 0.09\nnegative = -1\n"
      "more = 5.1\nword = \"x\"\n",
      "t.toml");
  const auto asked = [&](const char* key) { return absent_or(table, key, 0.1, 5); };
  CHECK_FALSE(asked("other"));
  CHECK(asked("zero") == 0.0);
  CHECK(asked("low") == 0.1);
  CHECK(asked("high") == 5.0);
  CHECK_THROWS_WITH(asked("less"), "t.toml:4: less: is 0.09, must be 0 or 0.1 to 5");
  for (const char* key : {"negative", "more", "word"}) CHECK_THROWS_AS(asked(key), BadInput);
}
