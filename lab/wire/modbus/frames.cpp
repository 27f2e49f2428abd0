// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/modbus/frames.hpp"

#include <array>

#include "lab/wire/modbus/pdu.hpp"

namespace triax::lab {
namespace {

constexpr std::array<std::uint16_t, 256> crc_table() {
  std::array<std::uint16_t, 256> table{};
  for (unsigned byte = 0; byte < table.size(); ++byte) {
    unsigned rest = byte;
    for (int bit = 0; bit < 8; ++bit) rest = (rest & 1U) != 0 ? rest >> 1U ^ 0xA001U : rest >> 1U;
    table[byte] = static_cast<std::uint16_t>(rest);
  }
  return table;
}

}  // namespace

std::uint16_t modbus_crc(std::string_view bytes) {
  static constexpr auto kTable = crc_table();
  unsigned rest = 0xFFFFU;
  for (const char c : bytes)
    rest = rest >> 8U ^ kTable[(rest ^ static_cast<unsigned char>(c)) & 0xFFU];
  return static_cast<std::uint16_t>(rest);
}

bool crc_holds(std::string_view frame) {
  if (frame.size() < 2) return false;
  const auto body = frame.size() - 2;
  return modbus_crc(frame.substr(0, body)) ==
         (byte_at(frame, body) | byte_at(frame, body + 1) << 8U);
}

std::string tcp_frame(unsigned transaction, int unit, std::string_view pdu) {
  std::string frame;
  put_word(frame, transaction);
  put_word(frame, 0);
  put_word(frame, static_cast<unsigned>(pdu.size() + 1));
  frame += static_cast<char>(unit);
  return frame.append(pdu);
}

std::string rtu_frame(int unit, std::string_view pdu) {
  std::string frame(1, static_cast<char>(unit));
  frame.append(pdu);
  const unsigned crc = modbus_crc(frame);
  frame += static_cast<char>(crc & 0xFFU);
  frame += static_cast<char>(crc >> 8U);
  return frame;
}

double rtu_silence_s(int baud) {
  constexpr int kFixedFrom = 19200;
  constexpr double kFixed_s = 1.75e-3, kCharacters = 3.5, kBits = 11;
  return baud > kFixedFrom ? kFixed_s : kCharacters * kBits / baud;
}

}  // namespace triax::lab
