// SPDX-License-Identifier: GPL-3.0-or-later
// Instruments with trees of their own, as their clients ask them.
#include <catch2/catch.hpp>

#include "lab/wire/instruments/multimeter_34401a.hpp"
#include "lab/wire/instruments/number_logger.hpp"
#include "lab/wire/instruments/scanner_34970a.hpp"
#include "lab/wire/instruments/serial_pad.hpp"
#include "lab/wire/scpi/scpi_conversation.hpp"

using namespace triax::lab;

namespace {
std::string said(Conversation& client, const std::string& message) {
  std::string reply;
  client.take(message + "\n", reply);
  if (reply.ends_with('\n')) reply.pop_back();
  return reply;
}

struct Channels {
  std::vector<double> values;
  WireDevice device{.name = "logger", .identity = Scanner34970A::kIdentity};
  explicit Channels(std::size_t count) : values(count) {
    for (std::size_t i = 0; i < count; ++i)
      device.points.push_back({fmt::format("channel{}_V", i + 1), [this, i] { return values[i]; }});
  }
};

struct Scanned : Channels {
  Scanned() : Channels(25) {}
  Scanner34970A scanner{device, 951'782'400.0};  // 29 February 2000
  ScpiConversation client{scanner.table(), device};
  std::string ask(const std::string& message) { return said(client, message); }
};
}  // namespace

TEST_CASE("the 34401A answers as sigrok's scpi-dmm asks") {
  Channels one(1);
  one.values[0] = -1.23456789;
  const Multimeter34401A meter(one.device);
  ScpiConversation client(meter.table(), one.device);
  CHECK(said(client, "*OPC?") == "1");
  CHECK(said(client, "CONF?") == "\"VOLT +1.000000E+01,+1.000000E-05\"");
  CHECK(said(client, "FETC?") == "");
  CHECK(said(client, "SYST:ERR?").starts_with("-230"));
  CHECK(said(client, "INIT") == "");
  one.values[0] = 2;
  CHECK(said(client, "FETC?") == "-1.23456789E+00");
  CHECK(said(client, "READ?") == "+2.00000000E+00");
  CHECK(said(client, "CONF:VOLT:DC 0.5;:CONF?") == "\"VOLT +1.000000E+00,+1.000000E-06\"");
  CHECK(said(client, "ABORT") == "");
  one.values[0] = NAN;
  CHECK(said(client, "MEAS:VOLT:DC?") == "+9.90000000E+37");
  CHECK(said(client, "SYST:ERR?") == "0,\"No error\"");
}

TEST_CASE("the 34970A scans its list and gives each reading once") {
  Scanned asked;
  asked.values = std::vector<double>(25, 1.5);
  CHECK(asked.ask("ROUT:SCAN (@103,101,102)") == "");
  CHECK(asked.ask("ROUT:SCAN?") == "#214(@101,102,103)");
  asked.values[1] = -2;
  CHECK(asked.ask("READ?") == "+1.50000000E+00,-2.00000000E+00,+1.50000000E+00");
  CHECK(asked.ask("FETC?;DATA:POIN?") == "+1.50000000E+00,-2.00000000E+00,+1.50000000E+00;+3");
  CHECK(asked.ask("DATA:REM? 2") == "+1.50000000E+00,-2.00000000E+00");
  CHECK(asked.ask("DATA:REM? 2") == "");
  CHECK(asked.ask("R? 9") == "#215+1.50000000E+00");
  CHECK(asked.ask("R?") == "#10");
  CHECK(asked.ask("SYST:ERR?").starts_with("-222,\"Data out of range; there are 1 readings"));
  CHECK(asked.ask("ROUT:SCAN (@205)") == "");
  CHECK(asked.ask("ROUT:SCAN (@121);SCAN (@206)") == "");
  CHECK(asked.ask("SYST:ERR?;ERR?") ==
        "-222,\"Data out of range; there is no channel 121\";"
        "-222,\"Data out of range; there is no channel 206\"");
}

TEST_CASE("the 34970A's timer reads only what is there at its instants") {
  Scanned asked;
  asked.scanner.process(100);
  asked.ask(
      "ROUT:SCAN (@101,202);:TRIG:SOUR TIM;TIM 0.5;COUN 3;:FORM:READ:TIME ON;CHAN ON;UNIT ON");
  asked.values[0] = 1;
  asked.ask("INIT");
  CHECK(asked.scanner.next_scan_s() == 100.5);
  asked.scanner.process(100.4);
  CHECK(asked.scanner.readings() == 2);
  asked.values[0] = 2;
  asked.scanner.process(101.6);  // two instants were missed, one scan is taken
  CHECK(asked.scanner.readings() == 4);
  CHECK(asked.scanner.next_scan_s() == 102);
  CHECK(asked.ask("R? 3") ==
        "#3110+1.00000000E+00 VDC,00000000.000,101,+0.00000000E+00 "
        "VDC,00000000.000,202,+2.00000000E+00 VDC,00000001.600,101");
  asked.ask("FORM:READ:TIME:TYPE ABS");
  CHECK(asked.ask("DATA:REM? 1") == "+0.00000000E+00 VDC,2000,02,29,00,01,41.600,202");
  asked.scanner.process(102);
  asked.scanner.process(103);
  CHECK(asked.scanner.readings() == 2);  // three scans were wanted
  asked.ask("TRIG:COUN INF;:INIT;:ABOR");
  asked.scanner.process(110);
  CHECK(asked.scanner.readings() == 2);
  CHECK(asked.ask("READ?") == "");
  CHECK(asked.ask("SYST:ERR?").starts_with("-221"));
  asked.ask("TRIG:SOUR BUS;:INIT;*TRG;*TRG");
  CHECK(asked.scanner.readings() == 4);
}

TEST_CASE("the 34970A's memory overwrites its oldest readings and says so") {
  Scanned asked;
  asked.ask("ROUT:SCAN (@101:120);:TRIG:SOUR TIM;TIM 1;COUN INF;:INIT");
  for (int i = 1; i < 2500; ++i) asked.scanner.process(i);
  CHECK(asked.scanner.readings() == Scanner34970A::kMostReadings);
  CHECK(asked.ask("STAT:QUES:COND?") == "0");
  asked.values[0] = 7;
  asked.scanner.process(2500);
  CHECK(asked.scanner.readings() == Scanner34970A::kMostReadings);
  CHECK(asked.ask("STAT:QUES?") == "4096");
  asked.ask("INIT");
  CHECK(asked.ask("STAT:QUES:COND?") == "0");
}

TEST_CASE("a serial pad answers SS by eight lines of counts") {
  Channels pad(6);
  pad.values = {0, -1.4, 8388606.6, 1e9, -1e9, NAN};
  SerialPad client(pad.device);
  const std::string eight = "0\r\n-1\r\n8388607\r\n8388607\r\n-8388608\r\nOPEN\r\nOPEN\r\nOPEN\r";
  CHECK(said(client, "SS") == eight);
  CHECK(said(client, "SS\r") == eight);
  CHECK(said(client, "") == "");
  CHECK(said(client, "ss") == "?\r");
  CHECK(said(client, std::string(100, 'S')) == "");
  std::string reply;
  client.take("SS", reply);
  CHECK(reply.empty());
  CHECK(client.waits_s());
  client.silent(reply);
  CHECK(reply == eight + "\n");
}

TEST_CASE("the plainest logger says a number a line, asked or unasked") {
  Channels one(1);
  one.values[0] = 0.125;
  NumberLogger asked(one.device);
  CHECK(said(asked, "any") == "0.125\r");
  CHECK_FALSE(asked.waits_s());
  NumberLogger unasked(one.device, 0.5);
  CHECK(said(unasked, "any") == "");
  CHECK(unasked.waits_s() == 0.5);
  std::string reply;
  unasked.silent(reply);
  one.values[0] = NAN;
  unasked.silent(reply);
  CHECK(reply == "0.125\r\n\r\n");
}
