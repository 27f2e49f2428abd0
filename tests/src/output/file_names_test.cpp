// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/file_names.hpp"

#include <catch2/catch.hpp>

using triax::src::FileNames;

TEST_CASE("names of files differ, also by more than case, and stay short") {
  FileNames names;
  CHECK(names.take("a_b", 1) == "a_b");
  CHECK(names.take("a_b", 2) == "a_b_2");
  CHECK(names.take("a_b_2", 3) == "a_b_2_3");
  CHECK(names.take("A_B", 4) == "A_B_4");
  CHECK(names.take("a_b_4", 5) == "a_b_4_5");
  CHECK(names.take("a_b", 4) == "a_b_4_2");
  const std::string long_name(300, 'n');
  const std::string first = names.take(long_name, 6), second = names.take(long_name, 7);
  CHECK(first != second);
  CHECK(first.size() < 150);
  CHECK(first.substr(0, 100) == long_name.substr(0, 100));
}
