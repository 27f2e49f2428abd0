// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/modbus/modbus_conversation.hpp"

#include <algorithm>

namespace triax::lab {

std::string ModbusTcpConversation::answer(int unit, std::string_view request) const {
  constexpr int kItself = 255;
  const bool itself = units_.size() == 1 && (unit == 0 || unit == kItself);
  for (const ModbusUnit& one : units_)
    if (one.number == unit || itself) return answer_modbus(*one.map, *one.device, request);
  return exception_answer(byte_at(request, 0), ModbusException::nobody_there);
}

void ModbusTcpConversation::take(std::string_view bytes, std::string& reply) {
  if (over_) return;
  kept_.append(bytes);
  std::string_view rest = kept_;
  while (rest.size() >= kTcpHeader) {
    const std::size_t length = word_at(rest, 4);  // of unit and data unit
    if (word_at(rest, 2) != 0 || length < 2 || length > kLongestPdu + 1) {
      over_ = true;
      rest = {};
      break;
    }
    const std::size_t whole = kTcpHeader - 1 + length;
    if (rest.size() < whole) break;
    const int unit = static_cast<int>(byte_at(rest, 6));
    const auto request = rest.substr(kTcpHeader, length - 1);
    reply += tcp_frame(word_at(rest, 0), unit, answer(unit, request));
    rest.remove_prefix(whole);
  }
  kept_.erase(0, kept_.size() - rest.size());
}

ModbusRtuConversation::ModbusRtuConversation(std::vector<ModbusUnit> units, int baud)
    : units_(std::move(units)) {
  constexpr double kLeast_s = 0.02;
  silence_s_ = std::max(rtu_silence_s(baud), kLeast_s);
}

std::optional<double> ModbusRtuConversation::waits_s() const {
  return kept_.empty() && !lost_ ? std::nullopt : std::optional(silence_s_);
}

void ModbusRtuConversation::take(std::string_view bytes, std::string& reply) {
  if (lost_) return;
  kept_.append(bytes);
  std::string_view rest = kept_;
  while (rest.size() > 1) {
    const std::size_t length = request_length(rest.substr(1));
    if (length == kUnknownLength || length == 0) break;
    const std::size_t whole = length + kRtuAround;
    if (rest.size() < whole) break;
    lost_ = !crc_holds(rest.substr(0, whole));
    if (lost_) break;
    answer(rest.substr(0, whole), reply);
    rest.remove_prefix(whole);
  }
  lost_ = lost_ || rest.size() > kLongestRtu;
  kept_.erase(0, lost_ ? kept_.size() : kept_.size() - rest.size());
}

void ModbusRtuConversation::silent(std::string& reply) {
  if (kept_.size() > kRtuAround && crc_holds(kept_)) answer(kept_, reply);
  kept_.clear();
  lost_ = false;
}

void ModbusRtuConversation::answer(std::string_view frame, std::string& reply) const {
  const int unit = static_cast<int>(byte_at(frame, 0));
  const auto request = frame.substr(1, frame.size() - kRtuAround);
  for (const ModbusUnit& one : units_) {
    if (unit == 0) {
      answer_modbus(*one.map, *one.device, request);
    } else if (one.number == unit) {
      reply += rtu_frame(unit, answer_modbus(*one.map, *one.device, request));
    }
  }
}

}  // namespace triax::lab
