// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/served/served_instrument.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

#include "lab/base/bad_input.hpp"
#include "lab/wire/instruments/multimeter_34401a.hpp"
#include "lab/wire/instruments/number_logger.hpp"
#include "lab/wire/instruments/scanner_34970a.hpp"
#include "lab/wire/instruments/serial_pad.hpp"
#include "lab/wire/modbus/modbus_conversation.hpp"
#include "lab/wire/scpi/scpi_conversation.hpp"
#include "lab/wire/served/numbered_conversation.hpp"

namespace triax::lab {
namespace {

constexpr int kFirstOfScanner = 101;

std::vector<ScpiHeader> headers_of(const Personality& personality, const WireDevice& device) {
  std::vector<ScpiHeader> headers;
  for (const PersonalityPoint& point : personality.points)
    if (!point.scpi.empty() && device.find(point.name))
      headers.push_back({.point = point.name,
                         .pattern = point.scpi,
                         .readable = point.readable,
                         .writable = point.writable,
                         .help = point.help});
  return headers;
}

/// Where a channel stands among the points of its device; the only one is the first.
std::size_t place_of(const RigInstrument& one, const RigChannel& channel) {
  const int first = one.personality.name == "34970A" ? kFirstOfScanner : 1;
  const int at = channel.asked.at.value_or(first);
  if (at < first || at >= first + 20)
    throw BadInput(fmt::format("{}: channel {} is out of range; expected {} to {}", one.name, at,
                               first, first + 19));
  return static_cast<std::size_t>(at - first);
}

std::string identity_of(const RigInstrument& one) {
  return fmt::format("triax,{},{},1", one.personality.name, kSimulatedWord);
}

double unix_now_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace

ServedInstrument::ServedInstrument(const RigInstrument& described, const ServedPlant& plant,
                                   ServedDrives& drives)
    : described_(described), drives_(drives) {
  switch (described.role) {
    case RigRole::frame:
      device_ = drives.frame();
      break;
    case RigRole::cell:
      device_ = drives.cell_controller();
      break;
    case RigRole::back:
      device_ = drives.back_controller();
      break;
    case RigRole::reads:
      read_channels(plant);
  }
  device_.name = described.name;
  identity_ = device_.identity;
  make_conversation(described.link.is_modbus());
}

/// Points as its channels stand in it, in the instrument's own unit.
void ServedInstrument::read_channels(const ServedPlant& plant) {
  device_.identity = identity_of(described_);
  for (const RigChannel& channel : described_.channels) {
    if (!channel.quantity) continue;
    const std::size_t place = place_of(described_, channel);
    while (device_.points.size() <= place)
      device_.points.push_back({.name = fmt::format("channel {}", device_.points.size() + 1),
                                .read = [] { return std::numeric_limits<double>::quiet_NaN(); },
                                .write = {}});
    device_.points[place].read = [&plant, &channel] {
      const double si = plant.reading()[*channel.quantity];
      return channel.calibration.raw_of(
          std::isnan(si) ? si : sim::to_field(si, {.name = {}, .scale = channel.scale}));
    };
  }
}

void ServedInstrument::make_conversation(bool modbus) {
  const Personality& personality = described_.personality;
  const WireDevice& device = device_;
  if (modbus) {
    const auto map = std::make_shared<RegisterMap>(personality);
    const std::vector<ModbusUnit> units{{described_.link.unit, map.get(), &device}};
    speaker_ = map;
    const bool tcp = !described_.link.is_serial();
    talk_ = [this, units, tcp]() -> std::unique_ptr<Conversation> {
      std::unique_ptr<Conversation> talk;
      if (tcp)
        talk = std::make_unique<ModbusTcpConversation>(units);
      else
        talk = std::make_unique<ModbusRtuConversation>(units, described_.link.baud);
      return std::make_unique<SpoiltConversation>(std::move(talk), tcp, fault_);
    };
    return;
  }
  const auto scpi = [this, &device](const ScpiTable& table) {
    talk_ = [&table, &device] { return std::make_unique<ScpiConversation>(table, device); };
  };
  if (described_.role != RigRole::reads) {
    const auto table =
        std::make_shared<ScpiTable>(scpi_table_of(device, headers_of(personality, device)));
    speaker_ = table;
    scpi(*table);
  } else if (personality.name == "34401A") {
    const auto meter = std::make_shared<Multimeter34401A>(device);
    speaker_ = meter;
    scpi(meter->table());
  } else if (personality.name == "34970A") {
    const auto scanner = std::make_shared<Scanner34970A>(device, unix_now_s());
    speaker_ = scanner;
    process_ = [scanner = scanner.get()](double time_s) { scanner->process(time_s); };
    shift_calendar_ = [scanner = scanner.get()](double by_s) { scanner->shift_calendar(by_s); };
    scpi(scanner->table());
  } else if (personality.name == "pad") {
    talk_ = [&device] { return std::make_unique<SerialPad>(device); };
  } else if (personality.name == "number-a-line") {
    talk_ = [&device] { return std::make_unique<NumberLogger>(device, 1); };
  } else {
    throw BadInput(
        fmt::format("{}: instrument profile {} cannot be simulated; must be one of: 34401A, "
                    "34970A, pad, number-a-line, or a profile with a role in the rig",
                    described_.name, personality.name));
  }
}

std::unique_ptr<Conversation> ServedInstrument::conversation() {
  return std::make_unique<NumberedConversation>(talk_(), drives_);
}

void ServedInstrument::process(double time_s) {
  own_s_ += rate_ * (time_s - time_s_);
  time_s_ = time_s;
  if (process_) process_(own_s_);
}

void ServedInstrument::set_clock(double rate, double jump_s) {
  if (!shift_calendar_)
    throw Refused(Refused::Why::conflict, described_.name + " has no clock of its own");
  if (!(rate > 0 && rate <= 1000 && std::fabs(jump_s) <= 1e9))
    throw Refused(Refused::Why::out_of_range,
                  "the rate of a clock must be above 0 and at most 1000");
  rate_ = rate;
  shift_calendar_(jump_s);
}

void ServedInstrument::pretend(Pretence as) {
  device_.identity = as == Pretence::other_make ? "somebody,else,0,0"
                     : as == Pretence::twin     ? identity_ + "1"
                                                : identity_;
}

}  // namespace triax::lab
