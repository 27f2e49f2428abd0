// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/modbus/register_map.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/wire/modbus/hex.hpp"
#include "tests/lab/wire/modbus/tank.hpp"

using namespace triax::lab;

namespace {
struct ServedTank {
  Personality personality = tank_personality();
  Tank tank{personality, 1000};
  RegisterMap map{personality};
  std::string ask(std::string_view digits) { return answer_modbus(map, tank.device, hex(digits)); }
};
using Written = std::vector<std::pair<std::string, double>>;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
}  // namespace

TEST_CASE("registers are read by functions 3 and 4, floats with the high word first", "[modbus]") {
  ServedTank served;
  served.tank.values = {{"level_mm", 1.5}, {"force_N", -2}, {"state", 7}};
  CHECK(served.ask("03 0000 0005") == hex("03 0A 3FC00000 C0000000 0007"));
  CHECK(served.ask("04 0000 0005") == hex("04 0A 3FC00000 C0000000 0007"));
  CHECK(served.ask("04 0064 0001") == hex("04 02 0003"));  // 1.5 in steps of 0.5
  served.tank.values["level_mm"] = 1.3;
  CHECK(served.ask("04 0064 0001") == hex("04 02 0003"));  // 2.6 steps
  served.tank.values["level_mm"] = 1.5;
  CHECK(served.ask("04 0001 0002") == hex("04 04 0000 C000"));  // halves may be read
  CHECK(served.tank.heard == 5);
}

TEST_CASE("no value is NaN, 8000 or FFFF; a scaled integer stays at its end", "[modbus]") {
  ServedTank served;
  served.tank.values = {{"level_mm", kNan}, {"state", kNan}};
  CHECK(served.ask("04 0000 0002") == hex("04 04 7FC00000"));
  CHECK(served.ask("04 0064 0001") == hex("04 02 8000"));
  CHECK(served.ask("04 0004 0001") == hex("04 02 FFFF"));
  served.tank.values = {{"level_mm", 1e6}, {"state", 1e6}};
  CHECK(served.ask("04 0064 0001") == hex("04 02 7FFF"));
  CHECK(served.ask("04 0004 0001") == hex("04 02 FFFE"));
  served.tank.values = {{"level_mm", -1e6}};
  CHECK(served.ask("04 0064 0001") == hex("04 02 8001"));
}

TEST_CASE("bits are packed as in the standard's examples", "[modbus]") {
  ServedTank served;
  // V1.1b3, 6.11: coils 20 to 29 set to 1011 0011 10 by CD 01.
  CHECK(served.ask("0F 0013 000A 02 CD01") == hex("0F 0013 000A"));
  const int on[] = {1, 0, 1, 1, 0, 0, 1, 1, 1, 0};
  for (int i = 0; i < 10; ++i) CHECK(served.tank.values["coil_" + std::to_string(19 + i)] == on[i]);
  CHECK(served.ask("01 0013 000A") == hex("01 02 CD01"));
  CHECK(served.ask("02 0015 0003") == hex("02 01 03"));
  CHECK(served.ask("05 0014 FF00") == hex("05 0014 FF00"));
  CHECK(served.ask("05 0013 0000") == hex("05 0013 0000"));
  CHECK(served.ask("01 0013 000A") == hex("01 02 CE01"));
}

TEST_CASE("a float is written at once, several values in the order of addresses", "[modbus]") {
  ServedTank served;
  CHECK(served.ask("10 000A 0005 0A 42C80000 3F000000 0002") == hex("10 000A 0005"));
  CHECK(served.tank.written == Written{{"target_mm", 100}, {"rate_mm_per_s", 0.5}, {"mode", 2}});
  CHECK(served.ask("06 006E 0064") == hex("06 006E 0064"));
  CHECK(served.tank.written.back() == std::pair<std::string, double>("target_mm", 50));
}

TEST_CASE("what a device does not do is an exception and changes nothing", "[modbus]") {
  ServedTank served;
  const std::pair<const char*, const char*> cases[] = {
      {"07", "87 01"},                                 // a function that is none of ours
      {"2B 0E 01 00", "AB 01"},                        //
      {"03 0005 0001", "83 02"},                       // nothing there
      {"03 0003 0003", "83 02"},                       // partly
      {"01 0000 0001", "81 02"},                       //
      {"03 FFFF 0002", "83 02"},                       // beyond the last address
      {"03 0000 0000", "83 03"},                       // no register
      {"03 0000 007E", "83 03"},                       // 126 of them
      {"01 0013 07D1", "81 03"},                       // 2001 coils
      {"03 0000", "83 03"},                            // too short
      {"03 0000 0001 00", "83 03"},                    // too long
      {"05 0013 1234", "85 03"},                       // neither on nor off
      {"06 0000 0001", "86 02"},                       // only read
      {"06 000A 42C8", "86 03"},                       // half a float
      {"10 000A 0003 06 42C80000 3F00", "90 03"},      // one and a half
      {"10 000B 0001 02 0000", "90 03"},               // the other half
      {"10 000A 0002 02 42C8", "90 03"},               // count and length differ
      {"10 000A 0002 04 7FC00000", "90 03"},           // not a number
      {"10 000A 0004 08 42C80000 7F800000", "90 03"},  // infinity behind a good one
      {"10 000A 0002 04 44FA0000", "90 03"},           // 2000: refused, above the limit
      {"10 000A 0002 04 BF800000", "90 04"},           // -1: refused in its state
      {"0F 0013 000A 01 CD", "8F 03"},                 //
      {"0F 0013 000B 02 CD01", "8F 02"}};
  for (const auto& [request, answer] : cases) {
    INFO(request);
    CHECK(served.ask(request) == hex(answer));
    CHECK(served.tank.written.empty());
  }
  CHECK(served.tank.heard == std::ssize(cases));
}

TEST_CASE("what a device lacks is not there", "[modbus]") {
  ServedTank served;
  std::erase_if(served.tank.device.points, [](auto& p) { return p.name == "force_N"; });
  CHECK(served.ask("03 0002 0002") == hex("83 02"));
  CHECK(served.ask("03 0000 0002") == hex("03 04 00000000"));
}

TEST_CASE("what the personality only reads is not written, whatever the device could", "[modbus]") {
  ServedTank served;
  bool written = false;
  for (auto& point : served.tank.device.points)
    if (point.name == "state") point.write = [&](double) { written = true; };
  CHECK(served.ask("06 0004 0001") == hex("86 02"));
  CHECK_FALSE(written);
}

TEST_CASE("the identity stands in registers, filled up", "[modbus]") {
  ServedTank served;
  CHECK(served.ask("04 00C8 0009") == hex("04 12") + std::string("triax,tank,1,1.0\0\0", 18));
  CHECK(served.ask("04 00D7 0001") == hex("04 02 0000"));
  CHECK(served.ask("04 00D8 0001") == hex("84 02"));
  CHECK(served.ask("06 00C8 0001") == hex("86 02"));
}
