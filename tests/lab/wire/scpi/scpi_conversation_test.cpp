// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/scpi/scpi_conversation.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/wire/scpi/asked.hpp"

using namespace triax::lab;
using triax::wire_tests::AskedDevice;

TEST_CASE("a device's points are asked for and set by their headers") {
  AskedDevice asked;
  CHECK(asked.ask("*IDN?") == "triax,pressure controller,1,0");
  CHECK(asked.ask("MEAS:PRES?") == "100.125");
  asked.pressure_kPa = 1.0 / 3;
  CHECK(asked.ask("meas:pressure?") == "0.3333333333");
  asked.pressure_kPa = NAN;
  CHECK(asked.ask("MEAS:PRES?") == "9.91E37");
  CHECK(asked.ask("SOUR:PRES:TARG 123.5 kPa") == "");
  CHECK(asked.target_kPa == 123.5);
  CHECK(asked.ask(":PRES:TARG?") == "123.5");
  CHECK(asked.heard == 6);
  CHECK(asked.ask("SYST:ERR?") == "0,\"No error\"");
}

TEST_CASE("units of a message follow each other's path, and are answered in one line") {
  AskedDevice asked;
  CHECK(asked.ask("SOUR:PRES:TARG 50;TARG?;:MEAS:PRES?;*OPC?;PRES?") == "50;100.125;1;100.125");
  CHECK(asked.ask(" ; MEAS:PRES? ;; ") == "100.125");
  CHECK(asked.error_of("SOUR:PRES:TARG 50;MEAS:PRES?").starts_with("-113,"));
  CHECK(asked.ask("") == "");
  // An execution error ends its unit, a command error the message.
  CHECK(asked.ask("*OPC?;PRES:TARG 2000;*OPC?") == "1;1");
  CHECK(asked.ask("*OPC?;NONE;*OPC?") == "1");
  CHECK(asked.ask("*OPC?;*IDN?") == "1;triax,pressure controller,1,0");
}

TEST_CASE("what cannot be understood or done has its code") {
  AskedDevice asked;
  const std::pair<const char*, const char*> cases[] = {
      {"MEAS!PRES?", "-101,\"Invalid character; 'MEAS!PRES?'\""},
      {"PRES:TARG 1,,2", "-102,\"Syntax error; no parameter before a comma\""},
      {"PRES:TARG,1", "-103,\"Invalid separator; 'PRES:TARG,1'\""},
      {"PRES:TARG abc", "-104,\"Data type error; no number: 'abc'\""},
      {"PRES:TARG 1,2", "-108,\"Parameter not allowed; PRES:TARG\""},
      {"MEAS:PRES? 1", "-108,\"Parameter not allowed; MEAS:PRES?\""},
      {"PRES:TARG", "-109,\"Missing parameter\""},
      {"MEAS:PRES", "-113,\"Undefined header; 'MEAS:PRES'\""},
      {"MEAS2:PRES?", "-114,\"Header suffix out of range; 'MEAS2:PRES?'\""},
      {"PRES:TARG 1 mm", "-131,\"Invalid suffix; 'mm', its unit is kPa\""},
      {"PRES:TARG 2000", "-222,\"Data out of range; target_kPa is 0 to 1000\""},
      {"PRES:TARG -1", "-221,\"Settings conflict; the \"\"valve\"\" is shut\""},
      {"PRES:TARG \"1", "-151,\"Invalid string data; no closing quote\""},
      {"*IDN?;*OPC?", "-440,\"Query UNTERMINATED after indefinite response\""}};
  for (const auto& [message, error] : cases) CHECK(asked.error_of(message) == error);
  CHECK(asked.target_kPa == 100);
}

TEST_CASE("a message ends with LF, CR LF or a silence, in pieces of any size") {
  AskedDevice asked;
  std::string reply;
  for (const char c : std::string("*OPC?\r\nMEAS:")) asked.client.take(std::string(1, c), reply);
  CHECK(reply == "1\n");
  CHECK(asked.client.waits_s() == ScpiConversation::kSilence_s);
  asked.client.take("PRES?", reply);
  CHECK(reply == "1\n");
  asked.client.silent(reply);
  CHECK(reply == "1\n100.125\n");
  CHECK_FALSE(asked.client.waits_s());
  asked.client.take("*OPC?\n*OPC?\n", reply);
  CHECK(reply == "1\n100.125\n1\n1\n");
}

TEST_CASE("a line feed in a block is data, a semicolon in a text parts nothing") {
  AskedDevice asked;
  std::string got;
  asked.table.add("DATA", 2, "", [&](ScpiCall& call) {
    got = call.parameters.block();
    got += "|" + call.parameters.text();
  });
  CHECK(asked.ask("DATA #213a\nb;c\"#15x\n,d ,'e;f';*OPC?") == "1");
  CHECK(got == "a\nb;c\"#15x\n,d|e;f");
  // A text without its end does not wait for one.
  CHECK(asked.ask("DATA #11a,'e") == "");
  CHECK(asked.ask("*OPC?") == "1");
}

TEST_CASE("a message that is too long is thrown away whole, and costs no memory") {
  AskedDevice asked;
  const std::string piece(std::size_t{1} << 16, 'x');
  std::string reply;
  for (int i = 0; i < 160; ++i) asked.client.take(piece, reply);
  asked.client.take(" PRES:TARG 5\n", reply);
  CHECK(reply.empty());
  CHECK(asked.target_kPa == 100);
  CHECK(asked.ask("SYST:ERR?") == "-363,\"Input buffer overrun\"");
  CHECK(asked.ask("SYST:ERR?") == "0,\"No error\"");
  CHECK(asked.ask(fmt::format("{:>{}}", "*OPC?", ScpiConversation::kLongestMessage)) == "1");
  CHECK(asked.error_of(fmt::format("{:>{}}", "*OPC?", ScpiConversation::kLongestMessage + 1))
            .starts_with("-363"));
  // A block that says it is long waits for no end of it.
  asked.client.take("DATA #9999999999\n", reply);
  CHECK(asked.client.waits_s());
  asked.client.silent(reply);
  CHECK(asked.ask("*OPC?") == "1");
}

TEST_CASE("answers that nobody could take are thrown away") {
  AskedDevice asked;
  asked.table.add("MUCH?", 0, "", [](ScpiCall& call) { call.reply = std::string(3 << 20, 'y'); });
  std::string reply;
  asked.client.take("MUCH?\n", reply);
  CHECK(reply.size() == (3 << 20) + 1);
  asked.client.take("MUCH?\n", reply);
  CHECK(reply.size() == (3 << 20) + 1);
  CHECK(asked.ask("SYST:ERR?") == "-430,\"Query DEADLOCKED\"");
}
