// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_programme.hpp"

#include <catch2/catch.hpp>

TEST_CASE("a name in the name of a file has no folders, blanks or bytes beyond ASCII") {
  CHECK(triax::lab::in_file_name("R 0.825/é x-1") == "R_0.825____x-1");
}
