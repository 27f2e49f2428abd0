// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/link_address.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;
using Catch::Matchers::Equals;
using Kind = LinkAddress::Kind;

TEST_CASE("a link's address is read and said again") {
  for (const char* text :
       {"tcp://127.0.0.1:5025", "tcp://[::1]:0", "modbus-tcp://rig.lab:502/247",
        "serial:///dev/ttyUSB0?baud=9600", "serial:///tmp/pad?baud=19200&parity=odd&bits=7&stop=2",
        "modbus-rtu:///dev/ttyS1?baud=9600&parity=even&unit=3"}) {
    INFO(text);
    CHECK(to_text(parse_link(text)) == text);
    CHECK(parse_link(text) == parse_link(to_text(parse_link(text))));
  }
  const LinkAddress modbus = parse_link("modbus-tcp://[fe80::2]:1502/255");
  CHECK(modbus.kind == Kind::modbus_tcp);
  CHECK(modbus.host == "fe80::2");
  CHECK(modbus.port == 1502);
  CHECK(modbus.unit == 255);
  const LinkAddress serial = parse_link("serial:///dev/ttyUSB0");
  CHECK(serial.path == "/dev/ttyUSB0");
  CHECK(serial.baud == 9600);
  CHECK(serial.parity == LinkAddress::Parity::none);
  CHECK(serial.bits == 8);
  CHECK(serial.stop == 1);
}

TEST_CASE("only this machine reaches its loopback and its serial ports") {
  for (const char* local : {"tcp://127.0.0.1:1", "tcp://127.9.9.9:1", "tcp://[::1]:1",
                            "tcp://localhost:1", "serial:///dev/ttyUSB0"})
    CHECK(parse_link(local).is_local());
  for (const char* open : {"tcp://0.0.0.0:1", "tcp://10.0.0.1:1", "modbus-tcp://[::]:1/1"})
    CHECK_FALSE(parse_link(open).is_local());
}

TEST_CASE("what is no link's address is told with what is right") {
  const std::pair<const char*, const char*> cases[] = {
      {"127.0.0.1:5025",
       "unknown protocol; must be one of: tcp://, serial://, modbus-tcp://, modbus-rtu://"},
      {"http://a:1",
       "unknown protocol; must be one of: tcp://, serial://, modbus-tcp://, modbus-rtu://"},
      {"tcp://a", "the port is missing; expected tcp://HOST:PORT"},
      {"tcp://", "the port is missing; expected tcp://HOST:PORT"},
      {"tcp://[::1]", "the port is missing; expected tcp://HOST:PORT"},
      {"tcp://::1:5", "write an IPv6 address in brackets: [::1]"},
      {"tcp://:5", "the host is missing; expected tcp://HOST:PORT"},
      {"tcp://a:65536", "port is '65536'; must be an integer from 0 to 65535"},
      {"tcp://a:5/1", "unexpected text after the port; expected tcp://HOST:PORT"},
      {"tcp://a b:5", "a link must not contain spaces"},
      {"modbus-tcp://a:5", "the unit is missing; expected modbus-tcp://HOST:PORT/UNIT"},
      {"modbus-tcp://a:5/256", "unit is '256'; must be an integer from 0 to 255"},
      {"serial://ttyUSB0", "the path of the port must begin with '/', as in serial:///dev/ttyUSB0"},
      {"serial:///dev/x?baud=fast", "baud is 'fast'; must be an integer from 50 to 4000000"},
      {"serial:///dev/x?parity=both",
       "parity: 'both' is not valid; must be one of: none, even, odd"},
      {"serial:///dev/x?boud=9600",
       "unknown key 'boud'; did you mean 'baud'? (must be one of: baud, parity, bits, stop)"},
      {"serial:///dev/x?", "unknown key ''; must be one of: baud, parity, bits, stop"},
      {"modbus-rtu:///dev/x?baud=9600", "the unit is missing, as in ?baud=9600&unit=3"},
      {"modbus-rtu:///dev/x?unit=0", "unit is '0'; must be an integer from 1 to 247"}};
  for (const auto& [text, message] : cases)
    CHECK_THROWS_WITH(parse_link(text), Equals("'" + std::string(text) + "': " + message));
}
