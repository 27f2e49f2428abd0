// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes of the MODBUS Application Protocol Specification V1.1b3, section 6.
#include "lab/wire/modbus/pdu.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/wire/modbus/hex.hpp"

using namespace triax::lab;

TEST_CASE("requests and answers of the standard's examples have their length", "[modbus]") {
  for (const auto* request :
       {"01 0013 0013", "02 00C4 0016", "03 006B 0003", "04 0008 0001", "05 00AC FF00",
        "06 0001 0003", "0F 0013 000A 02 CD01", "10 0001 0002 04 000A 0102"}) {
    INFO(request);
    const auto bytes = hex(request);
    CHECK(request_length(bytes) == bytes.size());
    CHECK(request_length(bytes + "more") == bytes.size());
    CHECK((request_length(bytes.substr(0, 5)) == 0) == (bytes.size() > 5));
  }
  for (const auto* answer :
       {"01 03 CD6B05", "02 03 ACDB35", "03 06 022B 0000 0064", "04 02 000A", "05 00AC FF00",
        "06 0001 0003", "0F 0013 000A", "10 0001 0002", "81 02"}) {
    INFO(answer);
    const auto bytes = hex(answer);
    CHECK(answer_length(bytes) == bytes.size());
  }
  CHECK(request_length(hex("2B 0E 01 00")) == kUnknownLength);
  CHECK(request_length("") == 0);
  CHECK(answer_length("\x03") == 0);
}

TEST_CASE("a read request has the bytes of the standard's examples", "[modbus]") {
  CHECK(read_request(ModbusFunction::read_coils, 0x13, 0x13) == hex("01 0013 0013"));
  CHECK(read_request(ModbusFunction::read_holding_registers, 0x6B, 3) == hex("03 006B 0003"));
  CHECK(exception_answer(1, ModbusException::illegal_address) == hex("81 02"));
}

TEST_CASE("exceptions in words", "[modbus]") {
  CHECK(exception_text(2) == "exception 2 (illegal data address)");
  CHECK(exception_text(11) == "exception 11 (no response of the unit)");
  CHECK(exception_text(7) == "exception 7");
  CHECK(exception_text(0) == "exception 0");
  CHECK(exception_text(200) == "exception 200");
}
