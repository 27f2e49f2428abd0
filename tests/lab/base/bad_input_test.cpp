// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/bad_input.hpp"

#include <catch2/catch.hpp>

using triax::lab::BadInput;

TEST_CASE("bad input names file and line, and leaves out a line that is not known") {
  CHECK(std::string(BadInput("a.csv", 7, "text").what()) == "a.csv:7: text");
  CHECK(std::string(BadInput("a.csv", 0, "text").what()) == "a.csv: text");
}
