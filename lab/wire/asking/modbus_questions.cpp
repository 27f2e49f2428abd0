// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/asking/modbus_questions.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/wire/modbus/modbus_exchange.hpp"
#include "lab/wire/modbus/register_value.hpp"

namespace triax::lab {
namespace {

/// One value of a frame.
struct FramePart {
  PointRegister place;
  std::size_t index = 0;  ///< in the list of what was asked
  double value = 0;       ///< to be set
};
using Frame = std::vector<FramePart>;

ModbusFunction reading(const PointRegister& place) {
  switch (place.form) {
    case RegisterForm::coil:
      return ModbusFunction::read_coils;
    case RegisterForm::discrete:
      return ModbusFunction::read_discrete_inputs;
    default:
      break;
  }
  return place.input ? ModbusFunction::read_input_registers
                     : ModbusFunction::read_holding_registers;
}

int length(const Frame& frame) {
  return frame.back().place.address + frame.back().place.size() - frame.front().place.address;
}

/// Parts that follow each other without a hole share a frame; in the order given.
std::vector<Frame> joined_frames(const std::vector<FramePart>& parts, int most_registers,
                                 int most_bits) {
  std::vector<Frame> frames;
  for (const FramePart& part : parts) {
    const auto follows = [&](const Frame& frame) {
      const auto& last = frame.back().place;
      return reading(last) == reading(part.place) &&
             last.address + last.size() == part.place.address &&
             length(frame) + part.place.size() <= (last.is_bit() ? most_bits : most_registers);
    };
    if (frames.empty() || !follows(frames.back())) frames.emplace_back();
    frames.back().push_back(part);
  }
  return frames;
}

std::vector<double> frame_values(const Frame& frame, std::string_view data) {
  const bool bits = frame.front().place.is_bit();
  const auto bytes = static_cast<std::size_t>(bits ? (length(frame) + 7) / 8 : 2 * length(frame));
  if (data.size() != bytes)
    throw Malformed(fmt::format("{} bytes of values instead of {}", data.size(), bytes));
  std::vector<double> values;
  for (const FramePart& part : frame) {
    const auto from = static_cast<std::size_t>(part.place.address - frame.front().place.address);
    values.push_back(bits ? byte_at(data, from / 8) >> from % 8 & 1U
                          : value_of(part.place, data.substr(2 * from)));
  }
  return values;
}

std::string write_request(const Frame& frame) {
  const bool bits = frame.front().place.is_bit();
  const auto count = static_cast<unsigned>(length(frame));
  std::string data;
  if (bits) data.resize((count + 7) / 8);
  for (std::size_t i = 0; i < frame.size(); ++i)
    if (!bits) {
      data += registers_of(frame[i].place, frame[i].value);
    } else if (frame[i].value != 0) {
      data[i / 8] = static_cast<char>(byte_at(data, i / 8) | 1U << i % 8);
    }
  auto pdu = read_request(bits ? ModbusFunction::write_coils : ModbusFunction::write_registers,
                          frame.front().place.address, static_cast<int>(count));
  pdu += static_cast<char>(data.size());
  return pdu + data;
}

class ModbusQuestions : public Questions {
 public:
  ModbusQuestions(const Personality& personality, ModbusFraming framing, int unit)
      : personality_(personality), path_{framing, unit, 0} {}

  std::vector<Exchange> prepare(const std::vector<AskedValue>& /*asked*/) override { return {}; }

  std::optional<Exchange> identify() override {
    const auto& identity = personality_.identity;
    if (!identity.register_) return std::nullopt;
    return modbus_text_exchange(next(), *identity.register_, identity.registers);
  }

  std::vector<Question> read(const std::vector<AskedValue>& asked) override {
    std::vector<FramePart> parts;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const auto& point = by_modbus(asked[i].point);
      if (!point.readable) throw BadInput(fmt::format("{} is write-only", point.name));
      parts.push_back({point.registers.front(), i});
    }
    std::ranges::stable_sort(parts, {}, [](const FramePart& part) {
      return std::pair(reading(part.place), part.place.address);
    });
    std::vector<Question> questions;
    for (const Frame& frame : joined_frames(parts, kMostRegistersRead, kMostBitsRead)) {
      const auto request =
          read_request(reading(frame.front().place), frame.front().place.address, length(frame));
      Question& question = questions.emplace_back();
      question.exchange = modbus_exchange(
          next(), request, [frame](std::string_view data) { return frame_values(frame, data); });
      for (const FramePart& part : frame) question.places.push_back(part.index);
    }
    return questions;
  }

  std::vector<Exchange> set(const std::vector<PointSetting>& settings) override {
    std::vector<FramePart> parts;
    for (const PointSetting& one : settings) {
      const auto& point = by_modbus(one.point);
      if (!point.writable) throw BadInput(fmt::format("{} is read-only", point.name));
      const auto order = static_cast<std::size_t>(&point - personality_.points.data());
      parts.push_back({point.registers.front(), order, one.value});
      if (!can_hold(parts.back().place, one.value))
        throw BadInput(
            fmt::format("{} = {} is too large for its registers", point.name, one.value));
    }
    std::ranges::stable_sort(parts, {}, &FramePart::index);
    std::vector<Exchange> exchanges;
    for (const Frame& frame : joined_frames(parts, kMostRegistersWritten, kMostBitsWritten))
      exchanges.push_back(modbus_exchange(next(), write_request(frame)));
    return exchanges;
  }

 private:
  ModbusPath next() {
    constexpr unsigned kTransactions = 0x10000U;
    path_.transaction = (path_.transaction + 1) % kTransactions;
    return path_;
  }
  const PersonalityPoint& by_modbus(const std::string& name) const {
    const auto& point = personality_.at(name);
    if (point.registers.empty())
      throw BadInput(fmt::format("{} has no registers for {}", personality_.title, name));
    return point;
  }

  const Personality& personality_;
  ModbusPath path_;
};

}  // namespace

std::unique_ptr<Questions> modbus_questions(const Personality& personality, ModbusFraming framing,
                                            int unit) {
  return std::make_unique<ModbusQuestions>(personality, framing, unit);
}

}  // namespace triax::lab
