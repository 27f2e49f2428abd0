// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/api/json_body.hpp"

#include <catch2/catch.hpp>

#include "src/page/request/request.hpp"

using namespace triax::src;

TEST_CASE("only an object of little depth is a body") {
  CHECK(text_in(json_body(R"({"who":"[[[[[[[[[[[[[[[[[[[[\"[["})"), "who") ==
        "[[[[[[[[[[[[[[[[[[[[\"[[");
  for (const std::string& bad : {std::string(), std::string("[]"), std::string("{"),
                                 std::string("1"), R"({"a":)" + std::string(100000, '[')})
    CHECK_THROWS_AS(json_body(bad), Refused);
}

TEST_CASE("numbers and texts are what they are called") {
  const auto body = json_body(R"({"p":1.5,"eta":[0.5,0.6],"q":2,"n":null,"t":"x"})");
  CHECK(number_in(body, "p") == 1.5);
  CHECK_FALSE(number_in(body, "n"));
  CHECK_FALSE(number_in(body, "absent"));
  CHECK(numbers_in(body, "eta") == std::vector{0.5, 0.6});
  CHECK(numbers_in(body, "q") == std::vector{2.0});
  CHECK_THROWS_AS(number_in(body, "t"), Refused);
  CHECK_THROWS_AS(numbers_in(body, "t"), Refused);
  CHECK_THROWS_AS(text_in(body, "p"), Refused);
  CHECK(flag_in(json_body(R"({"rig":true})"), "rig"));
  CHECK_FALSE(flag_in(body, "n"));
  CHECK_FALSE(flag_in(body, "absent"));
  CHECK_THROWS_AS(flag_in(body, "t"), Refused);
}
