// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/modbus/modbus_exchange.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/wire/modbus/hex.hpp"

using namespace triax::lab;
using Catch::Matchers::Contains;

namespace {
const auto kRead = hex("03 006B 0003");
std::vector<double> first_byte(std::string_view data) {
  return {static_cast<double>(byte_at(data, 1))};
}
Exchange over_tcp() { return modbus_exchange({ModbusFraming::tcp, 5, 0x1501}, kRead, first_byte); }
Exchange over_rtu() { return modbus_exchange({ModbusFraming::rtu, 5}, kRead, first_byte); }
}  // namespace

TEST_CASE("a question by TCP and its answer", "[modbus]") {
  const auto exchange = over_tcp();
  CHECK(exchange.request == hex("1501 0000 0006 05 03 006B 0003"));
  const auto answer = hex("1501 0000 0009 05 03 06 022B 0000 0064");
  for (std::size_t i = 0; i < answer.size(); ++i) CHECK(exchange.whole(answer.substr(0, i)) == 0);
  CHECK(exchange.whole(answer) == answer.size());
  CHECK(exchange.whole(answer + "more") == answer.size());
  CHECK(exchange.values(answer) == std::vector<double>{0x2B});
}

TEST_CASE("a question by RTU and its answer", "[modbus]") {
  const auto exchange = over_rtu();
  CHECK(exchange.request == rtu_frame(5, kRead));
  const auto answer = rtu_frame(5, hex("03 06 022B 0000 0064"));
  for (std::size_t i = 0; i < answer.size(); ++i) CHECK(exchange.whole(answer.substr(0, i)) == 0);
  CHECK(exchange.whole(answer) == answer.size());
  CHECK(exchange.values(answer) == std::vector<double>{0x2B});
}

TEST_CASE("what is no answer to the question is malformed, in words", "[modbus]") {
  const std::pair<const char*, const char*> tcp[] = {
      {"1500 0000 0009 05", "a response to query 5376 instead of 5377"},
      {"1501 0001 0009 05", "protocol is not 0"},
      {"1501 0000 0002 05", "a length of 2"},
      {"1501 0000 0100 05", "a length of 256"},
      {"1501 0000 0009 06", "a response from unit 6 to a query to unit 5"},
      {"1501 0000 0009 05 04", "a response to function 4 instead of 3"},
      {"1501 0000 0007 05 03 06 022B 0000", "does not fit"}};
  for (const auto& [bytes, words] : tcp) {
    INFO(bytes);
    CHECK_THROWS_WITH(over_tcp().whole(hex(bytes)), Contains(words));
  }
  CHECK_THROWS_WITH(over_rtu().whole("\x06"), Contains("a response from unit 6"));
  CHECK_THROWS_WITH(over_rtu().whole(hex("05 10")), Contains("a response to function 16"));
  auto spoilt = rtu_frame(5, hex("03 06 022B 0000 0064"));
  spoilt.back() = static_cast<char>(spoilt.back() ^ 1);
  CHECK_THROWS_WITH(over_rtu().whole(spoilt), Contains("a wrong checksum"));
}

TEST_CASE("an exception of the instrument is malformed, in words", "[modbus]") {
  const auto tcp = hex("1501 0000 0003 05 83 02"), rtu = rtu_frame(5, hex("83 04"));
  CHECK(over_tcp().whole(tcp) == tcp.size());
  CHECK_THROWS_WITH(over_tcp().values(tcp), "exception 2 (illegal data address)");
  CHECK(over_rtu().whole(rtu) == rtu.size());
  CHECK_THROWS_WITH(over_rtu().values(rtu), "exception 4 (device failure)");
}

TEST_CASE("a setting must be repeated", "[modbus]") {
  const auto exchange = modbus_exchange({ModbusFraming::rtu, 5}, hex("10 0001 0002 04 000A 0102"));
  CHECK(exchange.values(rtu_frame(5, hex("10 0001 0002"))).empty());
  CHECK_THROWS_WITH(exchange.values(rtu_frame(5, hex("10 0001 0001"))),
                    Contains("another setting"));
  CHECK_THROWS_AS(exchange.values(rtu_frame(5, hex("90 03"))), Malformed);
}

TEST_CASE("a text in registers", "[modbus]") {
  const auto exchange = modbus_text_exchange({ModbusFraming::rtu, 5}, 200, 4);
  CHECK(exchange.request == rtu_frame(5, hex("04 00C8 0004")));
  CHECK(exchange.text(rtu_frame(5, hex("04 08 74 72 69 61 78 00 00 00"))) == "triax");
  CHECK_THROWS_AS(exchange.text(rtu_frame(5, hex("04 06 74 72 69 61 78 00"))), Malformed);
}
