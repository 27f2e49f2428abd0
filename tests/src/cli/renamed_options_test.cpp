// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/renamed_options.hpp"

#include <catch2/catch.hpp>

using triax::src::with_names_of_today;
using Arguments = std::vector<std::string>;

TEST_CASE("options get the names of today, those of other commands stay") {
  CHECK(with_names_of_today({"domain", "--threads", "2"}) == Arguments{"domain", "--jobs", "2"});
  CHECK(with_names_of_today({"probe", "--p=70", "--q", "5"}) ==
        Arguments{"probe", "--p-kPa=70", "--q-kPa", "5"});
  CHECK(with_names_of_today({"probe", "--path", "--p-kPa", "--threads"}) ==
        Arguments{"probe", "--path", "--p-kPa", "--threads"});
  CHECK(with_names_of_today({"replay", "--csv"}) == Arguments{"replay", "--csv"});
  CHECK(with_names_of_today({}).empty());
}
