// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/personality.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;
using Catch::Matchers::Contains;

TEST_CASE("the shipped personalities", "[personality]") {
  std::vector<std::string> names;
  for (const auto& one : shipped_personalities()) names.push_back(one.name);
  CHECK(names == std::vector<std::string>{"34401A", "34970A", "number-a-line", "pad",
                                          "triax-controller", "triax-frame"});
  const auto controller = find_personality("triax-controller");
  CHECK(controller.speaks(Protocol::scpi));
  CHECK(controller.speaks(Protocol::modbus));
  CHECK_FALSE(controller.speaks(Protocol::lines));
  const auto& target = controller.at("target_kPa");
  CHECK(target.scpi == "SOURce:PRESsure:TARGet");
  CHECK(target.readable);
  CHECK(target.writable);
  REQUIRE(target.registers.size() == 2);
  CHECK(target.registers[0].address == 20);
  CHECK_FALSE(target.registers[0].input);
  CHECK(target.registers[1].form == RegisterForm::int16);
  CHECK(target.registers[1].factor == 0.1);
  CHECK(controller.at("pressure_kPa").registers[0].input);
  CHECK(controller.at("valve_open").registers[0].form == RegisterForm::coil);
  CHECK_THROWS_WITH(find_personality("triax-controler"),
                    Contains("did you mean 'triax-controller'"));
}

TEST_CASE("what takes effect by mode is set before it, on both ways", "[personality]") {
  for (const auto* name : {"triax-controller", "triax-frame"}) {
    const auto personality = find_personality(name);
    CHECK(personality.points.back().name == "mode");
    int highest = -1;
    for (const auto& point : personality.points) {
      CHECK_FALSE(point.help.empty());
      CHECK_FALSE(point.scpi.empty());
      REQUIRE_FALSE(point.registers.empty());
      if (!point.writable || point.registers[0].is_bit()) continue;
      if (highest >= 0) CHECK(point.registers[0].address == highest);
      highest = point.registers[0].address + point.registers[0].size();
    }
  }
}

TEST_CASE("an identity is held against the make", "[personality]") {
  const auto controller = find_personality("triax-controller"), meter = find_personality("34401A");
  CHECK(controller.complaint_about("triax,pressure controller,cell,1.0\n").empty());
  CHECK_THAT(controller.complaint_about("triax,loading frame,1,1"),
             Contains("the identity is 'triax,loading frame,1,1'; that of a pressure/volume "
                      "controller begins with"));
  CHECK(meter.complaint_about("HEWLETT-PACKARD,34401A,0,11-5-2").empty());
  CHECK_THAT(meter.complaint_about("HEWLETT-PACKARD,34970A,0,1"), Contains("contains '34401A'"));
  CHECK(find_personality("pad").complaint_about("").empty());
}

TEST_CASE("a faulty personality names file and line", "[personality]") {
  const std::string head = "title = \"x\"\nprotocol = \"modbus\"\n";
  const std::pair<std::string, const char*> cases[] = {
      {"", "x.toml"},
      {"title = \"x\"\n", "expected \"scpi\", \"modbus\", \"lines\""},
      {"title = \"x\"\nprotocol = \"scpy\"\n",
       "x.toml:2: protocol: 'scpy' is not valid; did you mean 'scpi'"},
      {head, "x.toml:2: protocol: modbus needs a value with registers"},
      {"title = \"x\"\nprotocol = \"scpi\"\n", "scpi needs [scan]"},
      {"title = \"x\"\nprotocol = \"lines\"\n", "lines needs [scan]"},
      {"title = \"x\"\nprotocol = [\"scpi\", \"lines\"]\n[scan]\nask = \"A\"\n",
       "give one of them"},
      {head + "[points.a]\nmodbus = { register = 1 }\n[points.b]\nmodbus = { register = 2 }\n",
       "x.toml:5: [points] b: register 2 is used by a already"},
      {head + "[identity]\nregister = 0\n[points.b]\nmodbus = { register = 2 }\n",
       "used by the identity already"},
      {head + "[points.a]\nmodbus = { register = 65535 }\n", "a float needs two registers"},
      {head + "[points.a]\nmodbus = { register = 1, coil = 2 }\n", "expected one of register"},
      {head + "[points.a]\nmodbus = { register = 1, form = \"float\" }\n", "unknown form 'float'"},
      {head + "[points.a]\nmodbus = { register = 1, factor = 2 }\n", "have a factor"},
      {head + "[points.a]\naccess = \"x\"\nmodbus = { register = 1 }\n",
       "must be one of: r, w, rw"},
      {head + "[points.a]\naccess = \"rw\"\nmodbus = { discrete = 1 }\n", "expected coil"},
      {head + "[points.a]\naccess = \"rw\"\nmodbus = { register = 1, input = true }\n",
       "cannot be written"},
      {head + "[points.a]\nmodbus = { register = 1 }\nhelpp = \"\"\n", "unknown key 'helpp'"},
      {head + "[line]\nterminator = \"\"\n", "terminator: expected"},
      {head + "[line]\ndeadline_ms = 0\n", "must be above 0"},
      {"title = \"x\"\nprotocol = \"lines\"\n[scan]\nlines = 2\n", "the first line is unknown"},
      {"title = \"x\"\nprotocol = \"scpi\"\n[scan]\nask = \"MEAS? (@{at})\"\nlines = 2\n",
       "leave out lines"}};
  for (const auto& [text, words] : cases) {
    INFO(text);
    CHECK_THROWS_WITH(parse_personality(text, "x.toml"), Contains(words));
    CHECK_THROWS_AS(parse_personality(text, "x.toml"), BadInput);
  }
}
