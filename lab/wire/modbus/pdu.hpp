// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Protocol data units as the MODBUS Application Protocol Specification V1.1b3 has them: a function
// code, then its data, words with their high byte first. What is around them is in frames.hpp.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace triax::lab {

enum class ModbusFunction : std::uint8_t {
  read_coils = 1,
  read_discrete_inputs = 2,
  read_holding_registers = 3,
  read_input_registers = 4,
  write_coil = 5,
  write_register = 6,
  write_coils = 15,
  write_registers = 16
};

enum class ModbusException : std::uint8_t {
  illegal_function = 1,
  illegal_address = 2,
  illegal_value = 3,
  device_failure = 4,
  nobody_there = 11  ///< of a gateway: no device of that unit
};
/// "exception 2 (illegal data address)"; others by their number.
std::string exception_text(unsigned code);

// Most of what one frame may ask for or set.
inline constexpr int kMostRegistersRead = 125, kMostRegistersWritten = 123;
inline constexpr int kMostBitsRead = 2000, kMostBitsWritten = 1968;
inline constexpr std::size_t kLongestPdu = 253;
inline constexpr unsigned kExceptionBit = 0x80U, kCoilOn = 0xFF00U;

void put_word(std::string& bytes, unsigned word);
/// Pre-condition: two bytes from `from` on.
unsigned word_at(std::string_view bytes, std::size_t from);
unsigned byte_at(std::string_view bytes, std::size_t from);

inline constexpr std::size_t kUnknownLength = static_cast<std::size_t>(-1);
/// Length of the request whose first bytes these are: 0 where more must come to say so,
/// kUnknownLength for a function that is none of ours.
std::size_t request_length(std::string_view pdu);
/// The same of an answer, exceptions among them.
std::size_t answer_length(std::string_view pdu);

std::string read_request(ModbusFunction function, int address, int count);
std::string exception_answer(unsigned function, ModbusException exception);

}  // namespace triax::lab
