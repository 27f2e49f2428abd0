// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is around a protocol data unit. TCP: transaction, protocol 0, length, unit ("MODBUS
// Messaging on TCP/IP", V1.0b). RTU: unit, data, CRC with its low byte first ("MODBUS over serial
// line", V1.02).
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace triax::lab {

enum class ModbusFraming { tcp, rtu };

inline constexpr std::size_t kTcpHeader = 7;  ///< bytes before the data unit
inline constexpr std::size_t kRtuAround = 3;  ///< bytes around it: one before, two behind
inline constexpr std::size_t kLongestRtu = 256;

/// x¹⁶ + x¹⁵ + x² + 1, reflected (0xA001), from 0xFFFF.
std::uint16_t modbus_crc(std::string_view bytes);
/// Whether the last two bytes are the CRC of those before.
bool crc_holds(std::string_view frame);

std::string tcp_frame(unsigned transaction, int unit, std::string_view pdu);
std::string rtu_frame(int unit, std::string_view pdu);

/// The silence that ends a frame: 3.5 characters of 11 bits, 1.75 ms from 19,200 baud on; s.
double rtu_silence_s(int baud);

}  // namespace triax::lab
