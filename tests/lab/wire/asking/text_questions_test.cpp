// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/wire/asking/questions.hpp"
#include "tests/lab/wire/modbus/tank.hpp"

using namespace triax::lab;
using Catch::Matchers::Contains;

namespace {
std::vector<std::string> requests(const std::vector<Exchange>& exchanges) {
  std::vector<std::string> all;
  for (const auto& one : exchanges) all.push_back(one.request);
  return all;
}
using Texts = std::vector<std::string>;
}  // namespace

TEST_CASE("values by SCPI: one message where the instrument can", "[asking]") {
  auto tank = tank_personality();
  const std::vector<AskedValue> asked{{"force_N", {}}, {"level_mm", {}}};
  const auto together = text_questions(tank)->read(asked);
  REQUIRE(together.size() == 1);
  CHECK(together[0].exchange.request == ":MEAS:FORC?;:MEAS:LEV?\n");
  CHECK(together[0].exchange.whole("1;+2.5E+00\r") == 0);
  CHECK(together[0].exchange.whole("1;+2.5E+00\r\n") == 12);
  CHECK(together[0].exchange.values("1;+2.5E+00\r\n") == std::vector<double>{1, 2.5});
  CHECK(together[0].places == std::vector<std::size_t>{0, 1});
  CHECK_THROWS_WITH(together[0].exchange.values("1\n"), Contains("1 numbers instead of 2: '1"));
  tank.compound = false;
  const auto apart = text_questions(tank)->read(asked);
  REQUIRE(apart.size() == 2);
  CHECK(apart[1].exchange.request == ":MEAS:LEV?\n");
  CHECK(apart[1].places == std::vector<std::size_t>{1});
}

TEST_CASE("values are set by SCPI in the personality's order and checked", "[asking]") {
  auto tank = tank_personality();
  const std::vector<PointSetting> settings{{"mode", 2}, {"rate_mm_per_s", 0.1}, {"target_mm", 100}};
  const auto together = text_questions(tank)->set(settings);
  CHECK(requests(together) ==
        Texts{":SOUR:TARG 100;:SOUR:RATE 0.1;:SYST:ERR?\n", ":SOUR:MODE 2;:SYST:ERR?\n"});
  CHECK(together[0].answered);
  CHECK(together[0].values("0,\"No error\"\n").empty());
  CHECK(together[0].values("+0,\"No error\"\n").empty());
  CHECK_THROWS_WITH(together[0].values("-222,\"Data out of range\"\n"),
                    "it reports: -222,\"Data out of range\"");
  CHECK_THROWS_AS(together[0].values("\n"), Malformed);
  tank.compound = false;
  const auto apart = text_questions(tank)->set(settings);
  CHECK(requests(apart) == Texts{":SOUR:TARG 100\n", ":SOUR:RATE 0.1\n", ":SYST:ERR?\n",
                                 ":SOUR:MODE 2\n", ":SYST:ERR?\n"});
  for (std::size_t i = 0; i < apart.size(); ++i) CHECK(apart[i].answered == (i == 2 || i == 4));
  CHECK(text_questions(tank)->set({}).empty());
  tank.set_check.clear();
  CHECK_FALSE(text_questions(tank)->set(settings).back().answered);
}

TEST_CASE("a scanner gets its list once and answers in rising order", "[asking]") {
  const auto scanner = find_personality("34970A");
  const auto questions = text_questions(scanner);
  const std::vector<AskedValue> asked{{"", 107}, {"", 101}, {"", 103}, {"", 101}};
  CHECK(requests(questions->prepare(asked)) ==
        Texts{"*CLS\n", "ROUT:SCAN (@101,103,107)\n", "TRIG:SOUR IMM\n", "TRIG:COUN 1\n",
              "FORM:READ:ALAR OFF\n", "FORM:READ:UNIT OFF\n", "FORM:READ:CHAN OFF\n",
              "FORM:READ:TIME:TYPE ABS\n", "FORM:READ:TIME ON\n"});
  const auto read = questions->read(asked);
  REQUIRE(read.size() == 1);
  CHECK(read[0].exchange.request == "READ?\n");
  CHECK(read[0].stamped);
  const std::string at = ",2000,03,01,00,00,01.500";
  CHECK(read[0].exchange.values("+1.0E+00" + at + ",+3.0E+00" + at + ",+7.0E+00" + at + "\n") ==
        std::vector<double>{7, 1, 3, 1, 951'868'801.5});
  CHECK_THROWS_AS(read[0].exchange.values("1,2,3\n"), Malformed);
  const auto identify = questions->identify();
  REQUIRE(identify);
  CHECK(identify->request == "*IDN?\n");
  CHECK(identify->text("HEWLETT-PACKARD,34970A,0,1-1-1\r\n") == "HEWLETT-PACKARD,34970A,0,1-1-1");
}

TEST_CASE("a multimeter has one value", "[asking]") {
  const auto meter = find_personality("34401A");
  const auto read = text_questions(meter)->read({{}});
  CHECK(read[0].exchange.values("+1.00000000E-01\n") == std::vector<double>{0.1});
  CHECK_THROWS_AS(text_questions(meter)->read({{"", 2}}), BadInput);
  CHECK_THROWS_WITH(text_questions(meter)->read({{"volt", {}}}),
                    Contains("its channels are numbered"));
}

TEST_CASE("a pad answers by eight lines", "[asking]") {
  const auto pad = find_personality("pad");
  const auto questions = text_questions(pad);
  CHECK_FALSE(questions->identify());
  const auto read = questions->read({{"", 8}, {"", 1}});
  REQUIRE(read.size() == 1);
  CHECK(read[0].exchange.request == "SS\r\n");
  const std::string answer = "11\r\n-12\r\n13\r\n14\r\n15\r\n16\r\n17\r\n18\r\n";
  CHECK(read[0].exchange.whole(answer.substr(0, answer.size() - 2)) == 0);
  CHECK(read[0].exchange.whole(answer) == answer.size());
  CHECK(read[0].exchange.values(answer) == std::vector<double>{18, 11});
  CHECK_THROWS_AS(read[0].exchange.values("11\r\n\r\n13\r\n14\r\n15\r\n16\r\n17\r\n18\r\n"),
                  Malformed);
  CHECK_THROWS_WITH(questions->read({{"", 9}}), Contains("no channel 9; expected 1 to 8"));
}

TEST_CASE("numbers that come unasked", "[asking]") {
  const auto logger = find_personality("number-a-line");
  const auto read = text_questions(logger)->read({{}});
  CHECK(read[0].exchange.request.empty());
  CHECK(read[0].exchange.whole("12.3") == 0);
  CHECK(read[0].exchange.whole("12.346\n12.4") == 7);
  CHECK(read[0].exchange.values("12.346\n") == std::vector<double>{12.346});
}

TEST_CASE("what cannot be asked or set by SCPI is bad input", "[asking]") {
  const auto tank = tank_personality();
  const auto questions = text_questions(tank);
  CHECK_THROWS_WITH(questions->read({{"coil_19", {}}}), Contains("over Modbus only"));
  CHECK_THROWS_WITH(questions->set({{"level_mm", 1}}), Contains("read-only"));
  CHECK_THROWS_WITH(questions->read({{"", 1}}), Contains("no numbered channels"));
}
