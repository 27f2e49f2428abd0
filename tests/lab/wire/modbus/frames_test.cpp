// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/modbus/frames.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/wire/modbus/hex.hpp"

using namespace triax::lab;

TEST_CASE("the CRC is that of the standard's example", "[modbus]") {
  // "MODBUS over Serial Line" V1.02, 6.2.2: 02 07 has the CRC 1241, sent as 41 12.
  CHECK(modbus_crc(hex("02 07")) == 0x1241);
  CHECK(rtu_frame(2, "\x07") == hex("02 07 41 12"));
  CHECK(modbus_crc("") == 0xFFFF);
  CHECK(modbus_crc("123456789") == 0x4B37);  // check value of CRC-16/MODBUS in catalogues
  CHECK(crc_holds(hex("02 07 41 12")));
  CHECK_FALSE(crc_holds(hex("02 07 12 41")));
  CHECK_FALSE(crc_holds(hex("02 06 41 12")));
  CHECK_FALSE(crc_holds("\x41"));
}

TEST_CASE("the header of TCP is that of the standard's example", "[modbus]") {
  // "MODBUS Messaging on TCP/IP" V1.0b, 4.4.2.2: transaction 1501, register 4 of unit FF.
  CHECK(tcp_frame(0x1501, 0xFF, hex("03 0004 0001")) == hex("1501 0000 0006 FF 03 0004 0001"));
}

TEST_CASE("the silence between frames", "[modbus]") {
  CHECK(rtu_silence_s(9600) == Approx(3.5 * 11 / 9600));
  CHECK(rtu_silence_s(19200) == Approx(3.5 * 11 / 19200));
  CHECK(rtu_silence_s(115200) == Approx(1.75e-3));
}
