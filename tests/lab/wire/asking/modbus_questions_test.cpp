// SPDX-License-Identifier: GPL-3.0-or-later
// The controller's questions against the instrument's own conversation.
#include "lab/wire/asking/modbus_questions.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/wire/modbus/modbus_conversation.hpp"
#include "tests/lab/wire/modbus/hex.hpp"
#include "tests/lab/wire/modbus/tank.hpp"

using namespace triax::lab;
using Catch::Matchers::Contains;

namespace {
struct AskedTank {
  Personality personality = tank_personality();
  Tank tank{personality, 1000};
  RegisterMap map{personality};
  ModbusTcpConversation tcp{{{3, &map, &tank.device}}};
  ModbusRtuConversation rtu{{{3, &map, &tank.device}}, 9600};

  std::string answer(const Exchange& exchange, ModbusFraming framing) {
    std::string reply;
    if (framing == ModbusFraming::tcp) tcp.take(exchange.request, reply);
    if (framing == ModbusFraming::rtu) rtu.take(exchange.request, reply);
    CHECK(exchange.whole(reply) == reply.size());
    return reply;
  }
};
}  // namespace

TEST_CASE("values are read in few frames, whatever their order", "[modbus][asking]") {
  AskedTank asked;
  asked.tank.values = {
      {"level_mm", 1.5}, {"force_N", -2}, {"state", 7}, {"mode", 3}, {"coil_20", 1}};
  for (const auto framing : {ModbusFraming::tcp, ModbusFraming::rtu}) {
    const auto questions = modbus_questions(asked.personality, framing, 3);
    CHECK(questions->prepare({}).empty());
    const auto few = questions->read({{"state", {}}, {"level_mm", {}}, {"force_N", {}}});
    REQUIRE(few.size() == 1);
    CHECK(few[0].places == std::vector<std::size_t>{1, 2, 0});
    CHECK(few[0].exchange.values(asked.answer(few[0].exchange, framing)) ==
          std::vector<double>{1.5, -2, 7});
    // A hole, another function, bits.
    const auto more = questions->read(
        {{"level_mm", {}}, {"state", {}}, {"mode", {}}, {"coil_20", {}}, {"coil_19", {}}});
    REQUIRE(more.size() == 4);
    std::vector<double> values(5, -1);
    for (const Question& one : more) {
      const auto said = one.exchange.values(asked.answer(one.exchange, framing));
      REQUIRE(said.size() == one.places.size());
      for (std::size_t i = 0; i < said.size(); ++i) values[one.places[i]] = said[i];
    }
    CHECK(values == std::vector<double>{1.5, 7, 3, 1, 0});
  }
}

TEST_CASE("a late answer is not taken for the next one", "[modbus][asking]") {
  AskedTank asked;
  const auto questions = modbus_questions(asked.personality, ModbusFraming::tcp, 3);
  const auto first = questions->read({{"state", {}}}), second = questions->read({{"state", {}}});
  const auto late = asked.answer(first[0].exchange, ModbusFraming::tcp);
  CHECK_THROWS_WITH(second[0].exchange.whole(late), Contains("a response to query 1 instead of 2"));
}

TEST_CASE("values are set in the personality's order, by one frame where they follow each other",
          "[modbus][asking]") {
  AskedTank asked;
  const auto questions = modbus_questions(asked.personality, ModbusFraming::rtu, 3);
  const auto exchanges =
      questions->set({{"mode", 2}, {"coil_21", 1}, {"target_mm", 100}, {"rate_mm_per_s", 0.5}});
  REQUIRE(exchanges.size() == 2);
  CHECK(exchanges[0].request == rtu_frame(3, hex("10 000A 0005 0A 42C80000 3F000000 0002")));
  CHECK(exchanges[1].request == rtu_frame(3, hex("0F 0015 0001 01 01")));
  for (const auto& one : exchanges)
    CHECK(one.values(asked.answer(one, ModbusFraming::rtu)).empty());
  CHECK(asked.tank.written ==
        std::vector<std::pair<std::string, double>>{
            {"target_mm", 100}, {"rate_mm_per_s", 0.5}, {"mode", 2}, {"coil_21", 1}});
  const auto refused = questions->set({{"target_mm", 2000}});
  CHECK_THROWS_WITH(refused[0].values(asked.answer(refused[0], ModbusFraming::rtu)),
                    "exception 3 (illegal data value)");
}

TEST_CASE("coils that follow each other are set by one frame", "[modbus][asking]") {
  AskedTank asked;
  const auto questions = modbus_questions(asked.personality, ModbusFraming::tcp, 3);
  std::vector<PointSetting> settings;
  for (int i = 19; i < 29; ++i)
    settings.push_back({"coil_" + std::to_string(i), i % 3 == 0 ? 1.0 : 0.0});
  const auto exchanges = questions->set(settings);
  REQUIRE(exchanges.size() == 1);
  exchanges[0].values(asked.answer(exchanges[0], ModbusFraming::tcp));
  for (const auto& [point, value] : settings) CHECK(asked.tank.values[point] == value);
}

TEST_CASE("an identity in registers", "[modbus][asking]") {
  AskedTank asked;
  const auto identify = modbus_questions(asked.personality, ModbusFraming::tcp, 3)->identify();
  REQUIRE(identify);
  CHECK(identify->text(asked.answer(*identify, ModbusFraming::tcp)) == "triax,tank,1,1.0");
  asked.personality.identity.register_ = {};
  CHECK_FALSE(modbus_questions(asked.personality, ModbusFraming::tcp, 3)->identify());
}

TEST_CASE("what cannot be asked or set is bad input", "[modbus][asking]") {
  AskedTank asked;
  const auto questions = modbus_questions(asked.personality, ModbusFraming::tcp, 3);
  CHECK_THROWS_WITH(questions->read({{"level", {}}}), Contains("did you mean 'level_mm'?"));
  CHECK_THROWS_AS(questions->read({{"", 1}}), BadInput);
  CHECK_THROWS_WITH(questions->set({{"state", 1}}), Contains("read-only"));
  CHECK_THROWS_WITH(questions->set({{"mode", 70000}}), Contains("too large for its registers"));
  CHECK_THROWS_AS(questions->set({{"mode", -1}}), BadInput);
  CHECK_THROWS_AS(questions->set({{"coil_19", 2}}), BadInput);
  CHECK_THROWS_AS(questions->set({{"target_mm", std::numeric_limits<double>::quiet_NaN()}}),
                  BadInput);
}
