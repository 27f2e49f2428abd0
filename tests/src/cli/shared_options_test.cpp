// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/shared_options.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax;
using namespace triax::src;

TEST_CASE("a piece is I of N; without one the whole is the only piece") {
  CHECK(piece_of("").index == 1);
  CHECK(piece_of("").count == 1);
  CHECK(piece_of("3/8").index == 3);
  CHECK(piece_of("3/8").count == 8);
  for (const char* bad : {"0/2", "3/2", "1", "1/2/3", "a/b", "1/", "/2", "1/2 "}) {
    INFO(bad);
    CHECK_THROWS_AS(piece_of(bad), lab::BadInput);
  }
}

TEST_CASE("KEY=VALUE is parted at the first equals sign") {
  using Pairs = std::vector<std::pair<std::string, std::string>>;
  CHECK(key_values({"a=1", "b.c=x=y"}, "") == Pairs{{"a", "1"}, {"b.c", "x=y"}});
  CHECK_THROWS_AS(key_values({"=1"}, ""), lab::BadInput);
  CHECK_THROWS_AS(key_values({"a"}, ""), lab::BadInput);
}
