// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/scpi/status.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/wire/scpi/asked.hpp"

using namespace triax::lab;
using triax::wire_tests::AskedDevice;

TEST_CASE(
    "errors are told in the order they came, and no more of them are kept than there is room") {
  ScpiStatus status;
  CHECK(status.take_error() == "0,\"No error\"");
  for (int i = 0; i < 25; ++i) status.put(ScpiError(-222, std::to_string(i)));
  CHECK(status.errors() == ScpiStatus::kMostErrors);
  for (int i = 0; i < 19; ++i)
    CHECK(status.take_error() == "-222,\"Data out of range; " + std::to_string(i) + "\"");
  CHECK(status.take_error() == "-350,\"Queue overflow\"");
  CHECK(status.take_error() == "0,\"No error\"");
}

TEST_CASE("errors set the event of their class, which the status byte sums up") {
  AskedDevice asked;
  CHECK(asked.ask("*ESR?") == "128");  // switched on
  CHECK(asked.ask("*ESR?") == "0");
  asked.ask("NONE");
  CHECK(asked.ask("*ESR?") == "32");
  asked.ask("PRES:TARG 2000");
  CHECK(asked.ask("*ESR?") == "16");
  asked.ask("*IDN?;*OPC?");
  CHECK(asked.ask("*ESR?") == "4");
  asked.ask("*OPC");
  CHECK(asked.ask("*STB?") == "4");  // errors wait
  asked.ask("*ESE 1;*SRE 255");
  CHECK(asked.ask("*ESE?;*SRE?") == "1;191");
  CHECK(asked.ask("*STB?") == "100");          // errors, events, service asked for
  CHECK(asked.ask("*OPC?;*STB?") == "1;116");  // and an answer waits
  asked.ask("*RST");
  CHECK(asked.resets == 1);
  CHECK(asked.ask("SYST:ERR:COUN?") == "3");
  asked.ask("*CLS");
  CHECK(asked.ask("SYST:ERR:COUN?;*STB?") == "0;80");
  CHECK(asked.ask("*ESE?") == "1");
}

TEST_CASE("a condition that comes on is an event until it is asked for") {
  AskedDevice asked;
  unsigned condition = 0;
  asked.table.questionable = [&] { return condition; };
  CHECK(asked.ask("STAT:QUES:COND?;EVEN?") == "0;0");
  asked.ask("STAT:QUES:ENAB 4096");
  condition = 4096;
  CHECK(asked.ask("*STB?") == "8");
  condition = 0;
  CHECK(asked.ask("STAT:QUES:COND?") == "0");
  CHECK(asked.ask("STAT:QUES?") == "4096");
  CHECK(asked.ask("STAT:QUES?") == "0");
  asked.ask("STAT:PRES");
  CHECK(asked.ask("STAT:QUES:ENAB?") == "0");
}
