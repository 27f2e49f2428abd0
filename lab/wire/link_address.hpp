// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where an instrument is, as a rig's file says it:
//     tcp://HOST:PORT                      modbus-tcp://HOST:PORT/UNIT
//     serial:///dev/ttyUSB0?baud=9600&parity=even|odd|none&bits=7|8&stop=1|2
//     modbus-rtu:///dev/ttyUSB0?baud=9600&parity=even&unit=3
// HOST is a name, an IPv4 address or an IPv6 one in brackets.
#include <string>
#include <string_view>

namespace triax::lab {

struct LinkAddress {
  enum class Kind { tcp, serial, modbus_tcp, modbus_rtu };
  enum class Parity { none, even, odd };
  Kind kind = Kind::tcp;
  std::string host;  ///< without brackets; of tcp and modbus_tcp
  int port = 0;      ///< 0: a free one, where it is listened
  std::string path;  ///< of serial and modbus_rtu: the port, or a pseudo-terminal
  int baud = 9600;   ///< 50 to 4,000,000
  Parity parity = Parity::none;
  int bits = 8;
  int stop = 1;
  int unit = 1;  ///< of modbus_tcp (0 to 255) and modbus_rtu (1 to 247)

  bool is_serial() const { return kind == Kind::serial || kind == Kind::modbus_rtu; }
  bool is_modbus() const { return kind == Kind::modbus_tcp || kind == Kind::modbus_rtu; }
  /// Only this machine reaches it: a serial port, localhost, 127.x.x.x, ::1.
  bool is_local() const;
  bool operator==(const LinkAddress&) const = default;
};

/// Throws BadInput, one line that begins with the text as excerpt() has it: what was found, what is
/// right.
LinkAddress parse_link(std::string_view text);
/// As parse_link() reads it; settings of a serial line that are the usual ones are left out.
std::string to_text(const LinkAddress& link);

}  // namespace triax::lab
