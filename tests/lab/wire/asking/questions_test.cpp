// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/asking/questions.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;
using Catch::Matchers::Contains;

TEST_CASE("the link says in which protocol an instrument is asked", "[asking]") {
  const auto controller = find_personality("triax-controller"), pad = find_personality("pad");
  const auto first = [&](const Personality& personality, const char* link,
                         const AskedValue& value) {
    return questions_for(personality, parse_link(link))->read({value})[0].exchange.request;
  };
  const AskedValue pressure{"pressure_kPa", {}};
  CHECK(first(controller, "tcp://localhost:5025", pressure) == ":MEAS:PRES?\n");
  CHECK(first(controller, "serial:///dev/ttyS0", pressure) == ":MEAS:PRES?\n");
  CHECK(first(controller, "modbus-tcp://localhost:502/7", pressure) ==
        std::string("\0\1\0\0\0\6\7\4\0\0\0\2", 12));
  CHECK(first(controller, "modbus-rtu:///dev/ttyS0?unit=7", pressure).substr(0, 6) ==
        std::string("\7\4\0\0\0\2", 6));
  CHECK(first(pad, "serial:///dev/ttyS0", {{}, 1}) == "SS\r\n");
  CHECK_THROWS_WITH(first(pad, "modbus-tcp://localhost:502/7", {{}, 1}),
                    Contains("has no Modbus interface"));
  const auto deaf = parse_personality(
      "title = \"x\"\nprotocol = \"modbus\"\n[points.a]\nmodbus = { register = 1 }\n", "x.toml");
  CHECK_THROWS_WITH(first(deaf, "tcp://localhost:502", {"a", {}}),
                    Contains("has a Modbus interface only"));
}
