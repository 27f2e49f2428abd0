// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/modbus/modbus_conversation.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/wire/modbus/hex.hpp"
#include "tests/lab/wire/modbus/tank.hpp"

using namespace triax::lab;

namespace {
struct TwoTanks {
  Personality personality = tank_personality();
  Tank one{personality}, two{personality};
  RegisterMap map{personality};
  std::vector<ModbusUnit> units{{1, &map, &one.device}, {2, &map, &two.device}};
  TwoTanks() {
    one.values["state"] = 1;
    two.values["state"] = 2;
  }
};
std::string said(Conversation& conversation, std::string_view bytes) {
  std::string reply;
  conversation.take(bytes, reply);
  return reply;
}
std::string after_silence(Conversation& conversation) {
  std::string reply;
  conversation.silent(reply);
  return reply;
}
}  // namespace

TEST_CASE("TCP: a frame in any pieces, several at once", "[modbus]") {
  TwoTanks tanks;
  ModbusTcpConversation conversation(tanks.units);
  const auto question = hex("1501 0000 0006 01 04 0004 0001 1502 0000 0006 02 04 0004 0001");
  const auto answer = hex("1501 0000 0005 01 04 02 0001 1502 0000 0005 02 04 02 0002");
  CHECK(said(conversation, question) == answer);
  std::string pieces;
  for (const char c : question) conversation.take(std::string_view(&c, 1), pieces);
  CHECK(pieces == answer);
  CHECK_FALSE(conversation.waits_s());
  CHECK_FALSE(conversation.over());
}

TEST_CASE("TCP: a wrong unit is answered as by a gateway; 0 and 255 are a device alone",
          "[modbus]") {
  TwoTanks tanks;
  ModbusTcpConversation both(tanks.units), alone({tanks.units[1]});
  const auto wrong = hex("0001 0000 0006 07 04 0004 0001");
  CHECK(said(both, wrong) == hex("0001 0000 0003 07 84 0B"));
  CHECK(said(alone, wrong) == hex("0001 0000 0003 07 84 0B"));
  for (const auto* unit : {"FF", "00"}) {
    const auto request = hex("0001 0000 0006") + hex(unit) + hex("04 0004 0001");
    CHECK(said(alone, request) == hex("0001 0000 0005") + hex(unit) + hex("04 02 0002"));
    CHECK(said(both, request) == hex("0001 0000 0003") + hex(unit) + hex("84 0B"));
  }
}

TEST_CASE("TCP: what is no Modbus ends the conversation", "[modbus]") {
  TwoTanks tanks;
  for (const auto* bytes :
       {"0001 0001 0006 01", "0001 0000 0001 01", "0001 0000 00FF 01", "GET / HTTP/1.1"}) {
    ModbusTcpConversation conversation(tanks.units);
    CHECK(said(conversation, bytes[0] == 'G' ? bytes : hex(bytes)).empty());
    CHECK(conversation.over());
    CHECK(said(conversation, hex("0001 0000 0006 01 04 0004 0001")).empty());
  }
}

TEST_CASE("RTU: a whole frame is answered at once", "[modbus]") {
  TwoTanks tanks;
  ModbusRtuConversation conversation(tanks.units, 9600);
  CHECK_FALSE(conversation.waits_s());
  const auto question = rtu_frame(2, hex("04 0004 0001"));
  std::string reply;
  for (const char c : question) {
    CHECK(reply.empty());
    conversation.take(std::string_view(&c, 1), reply);
  }
  CHECK(reply == rtu_frame(2, hex("04 02 0002")));
  CHECK_FALSE(conversation.waits_s());
  CHECK(said(conversation, rtu_frame(1, hex("10 000A 0002 04 42C80000"))) ==
        rtu_frame(1, hex("10 000A 0002")));
  CHECK(tanks.one.values["target_mm"] == 100);
}

TEST_CASE("RTU: a wrong check sum and a wrong unit are met with silence", "[modbus]") {
  TwoTanks tanks;
  ModbusRtuConversation conversation(tanks.units, 9600);
  auto spoilt = rtu_frame(2, hex("06 000E 0003"));
  spoilt[5] = static_cast<char>(spoilt[5] ^ 1);
  CHECK(said(conversation, spoilt).empty());
  CHECK(said(conversation, rtu_frame(2, hex("06 000E 0003"))).empty());  // before a silence
  CHECK(conversation.waits_s() == Approx(0.02));
  CHECK(after_silence(conversation).empty());
  CHECK(tanks.two.written.empty());
  CHECK(tanks.two.heard == 0);
  CHECK(said(conversation, rtu_frame(9, hex("06 000E 0003"))).empty());
  CHECK(said(conversation, rtu_frame(2, hex("06 000E 0003"))) == rtu_frame(2, hex("06 000E 0003")));
}

TEST_CASE("RTU: half a frame is dropped by a silence", "[modbus]") {
  TwoTanks tanks;
  ModbusRtuConversation conversation(tanks.units, 1200);
  const auto question = rtu_frame(2, hex("04 0004 0001"));
  CHECK(said(conversation, question.substr(0, 4)).empty());
  CHECK(conversation.waits_s() == Approx(3.5 * 11 / 1200));
  CHECK(after_silence(conversation).empty());
  CHECK(said(conversation, question) == rtu_frame(2, hex("04 02 0002")));
}

TEST_CASE("RTU: unit 0 is all of them, unanswered", "[modbus]") {
  TwoTanks tanks;
  ModbusRtuConversation conversation(tanks.units, 9600);
  CHECK(said(conversation, rtu_frame(0, hex("06 000E 0003"))).empty());
  CHECK(tanks.one.values["mode"] == 3);
  CHECK(tanks.two.values["mode"] == 3);
}

TEST_CASE("RTU: a function of unknown length is refused after the silence", "[modbus]") {
  TwoTanks tanks;
  ModbusRtuConversation conversation(tanks.units, 9600);
  CHECK(said(conversation, rtu_frame(2, hex("2B 0E 01 00"))).empty());
  CHECK(after_silence(conversation) == rtu_frame(2, hex("AB 01")));
}

TEST_CASE("RTU: what goes on without a silence is not kept", "[modbus]") {
  TwoTanks tanks;
  ModbusRtuConversation conversation(tanks.units, 9600);
  for (int i = 0; i < 100; ++i) CHECK(said(conversation, std::string(1000, '\x55')).empty());
  CHECK(after_silence(conversation).empty());
  CHECK(said(conversation, rtu_frame(2, hex("04 0004 0001"))) == rtu_frame(2, hex("04 02 0002")));
}

TEST_CASE("RTU: no frame is longer than 256 bytes", "[modbus]") {
  TwoTanks tanks;
  ModbusRtuConversation conversation(tanks.units, 9600);
  for (const std::size_t length : {256U, 257U}) {
    CHECK(said(conversation, rtu_frame(2, std::string(length - kRtuAround, '\x2b'))).empty());
    CHECK(after_silence(conversation) == (length > 256 ? "" : rtu_frame(2, hex("AB 01"))));
  }
}
