// SPDX-License-Identifier: GPL-3.0-or-later
// The first byte says which of four: an instrument or a controller, TCP or RTU; the rest are the
// bytes that reach it, in pieces of 1 to 8 bytes, with silences between.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "lab/wire/asking/modbus_questions.hpp"
#include "lab/wire/modbus/modbus_conversation.hpp"

namespace {

using namespace triax::lab;

const Personality& controller() {
  static const Personality personality = find_personality("triax-controller");
  return personality;
}

void require(bool holds) {
  if (!holds) std::abort();
}

/// Takes any number that is one, refuses some.
WireDevice device_of_fuzz() {
  WireDevice device{.name = "fuzz", .identity = "triax,pressure controller,fuzz,1"};
  for (const auto& point : controller().points) {
    Point made{.name = point.name, .read = [] { return 1.5; }};
    if (point.writable)
      made.write = [](double value) {
        require(std::isfinite(value));
        if (value > 1000) throw Refused(Refused::Why::out_of_range, "above 1000");
        if (value < 0) throw Refused(Refused::Why::conflict, "below 0");
      };
    device.points.push_back(made);
  }
  return device;
}

void instrument(Conversation& conversation, std::string_view bytes) {
  std::string reply;
  while (!bytes.empty() && !conversation.over()) {
    const auto piece = bytes.substr(0, 1 + static_cast<unsigned char>(bytes[0]) % 8);
    const std::size_t before = reply.size();
    conversation.take(piece, reply);
    require(reply.size() - before <= 8 * 270);
    if (piece.size() == 8 && conversation.waits_s()) conversation.silent(reply);
    bytes.remove_prefix(piece.size());
  }
}

void answered(const Exchange& exchange, std::string_view bytes) {
  try {
    for (std::size_t i = 0; i < bytes.size() && i < 300; ++i)
      if (const std::size_t length = exchange.whole(bytes.substr(0, i)); length != 0) {
        require(length <= i);
        if (exchange.values) exchange.values(bytes.substr(0, length));
        if (exchange.text) exchange.text(bytes.substr(0, length));
        return;
      }
  } catch (const Malformed&) {
    return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  std::string bytes(data + 1, data + size);
  const unsigned which = data[0];
  const bool tcp = which % 2 == 0;
  if (which / 2 % 2 == 0) {
    static const RegisterMap map(controller());
    static const WireDevice device = device_of_fuzz();
    const std::vector<ModbusUnit> units{{3, &map, &device}};
    ModbusTcpConversation by_tcp(units);
    ModbusRtuConversation by_rtu(units, 9600);
    instrument(tcp ? static_cast<Conversation&>(by_tcp) : by_rtu, bytes);
    return 0;
  }
  const auto questions =
      modbus_questions(controller(), tcp ? ModbusFraming::tcp : ModbusFraming::rtu, 3);
  answered(*questions->identify(), bytes);
  for (const auto& one :
       questions->read({{"pressure_kPa", {}}, {"volume_mm3", {}}, {"valve_open", {}}}))
    answered(one.exchange, bytes);
  for (const auto& one : questions->set({{"target_kPa", 1}, {"mode", 1}, {"valve_open", 1}}))
    answered(one, bytes);
  return 0;
}
