// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/modbus/pdu.hpp"

#include <fmt/format.h>

namespace triax::lab {

std::string exception_text(unsigned code) {
  constexpr std::string_view kWords[] = {"illegal function",
                                         "illegal data address",
                                         "illegal data value",
                                         "device failure",
                                         "acknowledge",
                                         "device busy",
                                         "",
                                         "memory parity error",
                                         "",
                                         "no path to the unit",
                                         "no response of the unit"};
  const bool known = code >= 1 && code <= std::size(kWords) && !kWords[code - 1].empty();
  return known ? fmt::format("exception {} ({})", code, kWords[code - 1])
               : fmt::format("exception {}", code);
}

void put_word(std::string& bytes, unsigned word) {
  bytes += static_cast<char>(word >> 8U & 0xFFU);
  bytes += static_cast<char>(word & 0xFFU);
}

unsigned byte_at(std::string_view bytes, std::size_t from) {
  return static_cast<unsigned char>(bytes[from]);
}

unsigned word_at(std::string_view bytes, std::size_t from) {
  return byte_at(bytes, from) << 8U | byte_at(bytes, from + 1);
}

std::size_t request_length(std::string_view pdu) {
  if (pdu.empty()) return 0;
  const unsigned function = byte_at(pdu, 0);
  constexpr std::size_t kShort = 5, kCountAt = 5;
  if (function >= 1 && function <= 6) return kShort;
  if (function != 15 && function != 16) return kUnknownLength;
  return pdu.size() > kCountAt ? kCountAt + 1 + byte_at(pdu, kCountAt) : 0;
}

std::size_t answer_length(std::string_view pdu) {
  if (pdu.empty()) return 0;
  const unsigned function = byte_at(pdu, 0);
  if ((function & kExceptionBit) != 0) return 2;
  if (function >= 1 && function <= 4) return pdu.size() > 1 ? 2 + byte_at(pdu, 1) : 0;
  const bool echo = function == 5 || function == 6 || function == 15 || function == 16;
  return echo ? 5 : kUnknownLength;
}

std::string read_request(ModbusFunction function, int address, int count) {
  std::string pdu(1, static_cast<char>(function));
  put_word(pdu, static_cast<unsigned>(address));
  put_word(pdu, static_cast<unsigned>(count));
  return pdu;
}

std::string exception_answer(unsigned function, ModbusException exception) {
  return {static_cast<char>(function | kExceptionBit), static_cast<char>(exception)};
}

}  // namespace triax::lab
