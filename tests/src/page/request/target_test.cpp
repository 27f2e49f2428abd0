// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/request/target.hpp"

#include <catch2/catch.hpp>

using triax::src::parse_target;

TEST_CASE("a target is its parts and values, escapes resolved once") {
  const auto target =
      parse_target("/api/tests/3/window?from=0&columns=q_kPa%2Cp_eff_kPa&set=a%3Db+c");
  REQUIRE(target);
  CHECK(target->path == std::vector<std::string>{"api", "tests", "3", "window"});
  CHECK(target->value("columns") == "q_kPa,p_eff_kPa");
  CHECK(target->value("set") == "a=b c");
  CHECK_FALSE(target->value("to"));
  CHECK(parse_target("/")->path.empty());
  CHECK(parse_target("/a%2525")->path.front() == "a%25");
  CHECK(parse_target("/?token=x")->value("token") == "x");
}

TEST_CASE("what leads elsewhere or is no text is no target") {
  for (const char* bad :
       {"", "api", "http://x/", "/..", "/a/../b", "/./a", "/%2e%2e/a", "/a%2fb", "/a%5cb", "/%00",
        "/a%0d%0ab", "/%", "/%z1", "/%c0%ae", "/\xff", "/a?x=%0a", "/a?%=1", "*"})
    CHECK_FALSE(parse_target(bad));
}
