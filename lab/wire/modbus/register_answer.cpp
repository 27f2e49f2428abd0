// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include "lab/wire/modbus/register_map.hpp"
#include "lab/wire/modbus/register_value.hpp"

namespace triax::lab {
namespace {

/// Ends the work on a request.
struct AnsweredBy {
  ModbusException exception;
};

struct Setting {
  const Point* point;
  double value;
};

class RegisterAnswer {
 public:
  RegisterAnswer(const RegisterMap& map, const WireDevice& device, std::string_view request)
      : map_(map), device_(device), request_(request) {}

  std::string made() {
    const std::size_t length = request_length(request_);
    if (length == kUnknownLength) throw AnsweredBy{ModbusException::illegal_function};
    if (length != request_.size()) throw AnsweredBy{ModbusException::illegal_value};
    address_ = static_cast<int>(word_at(request_, 1));
    switch (static_cast<ModbusFunction>(byte_at(request_, 0))) {
      case ModbusFunction::read_coils:
      case ModbusFunction::read_discrete_inputs:
        return read_bits();
      case ModbusFunction::read_holding_registers:
      case ModbusFunction::read_input_registers:
        return read_registers();
      case ModbusFunction::write_coil:
        return applied({coil(word_at(request_, 3))});
      case ModbusFunction::write_register:
        count_ = 1;
        return applied(registers(request_.substr(3)));
      case ModbusFunction::write_coils:
        return applied(coils());
      case ModbusFunction::write_registers:
        break;
    }
    take_count(kMostRegistersWritten, 2 * count());
    return applied(registers(request_.substr(6)));
  }

 private:
  int count() const { return static_cast<int>(word_at(request_, 3)); }
  /// `bytes` of data are right for a write.
  void take_count(int most, int bytes = -1) {
    count_ = count();
    const bool wrong_length = bytes >= 0 && byte_at(request_, 5) != static_cast<unsigned>(bytes);
    if (count_ < 1 || count_ > most || wrong_length)
      throw AnsweredBy{ModbusException::illegal_value};
  }
  const RegisterMap::Spot& spot(bool bit, int address) const {
    const auto* found = map_.find(bit, address);
    if (found == nullptr) throw AnsweredBy{ModbusException::illegal_address};
    return *found;
  }
  double value_at(const RegisterMap::Spot& spot) const {
    const Point* point = spot.readable ? device_.find(spot.point) : nullptr;
    if (point == nullptr || !point->read) throw AnsweredBy{ModbusException::illegal_address};
    return point->read();
  }
  const Point& settable(const RegisterMap::Spot& spot) const {
    const Point* point = spot.writable ? device_.find(spot.point) : nullptr;
    if (point == nullptr || !point->write) throw AnsweredBy{ModbusException::illegal_address};
    return *point;
  }

  std::string read_bits() {
    take_count(kMostBitsRead);
    std::string bytes(static_cast<std::size_t>(count_ + 7) / 8, '\0');
    for (int i = 0; i < count_; ++i)
      if (const double value = value_at(spot(true, address_ + i)); value != 0 && value == value)
        bytes[i / 8] =
            static_cast<char>(byte_at(bytes, i / 8) | 1U << static_cast<unsigned>(i % 8));
    return with_length(bytes);
  }
  std::string read_registers() {
    take_count(kMostRegistersRead);
    std::string bytes;
    for (int at = address_; at < address_ + count_;) {
      const auto& here = spot(false, at);
      const int end = std::min(address_ + count_, here.place.address + here.place.size());
      bytes.append(words(here).substr(2 * (at - here.place.address), 2 * (end - at)));
      at = end;
    }
    return with_length(bytes);
  }
  std::string words(const RegisterMap::Spot& spot) const {
    if (!spot.point.empty()) return registers_of(spot.place, value_at(spot));
    const std::size_t from =
        2 * static_cast<std::size_t>(spot.place.address - map_.identity_from());
    std::string two = from < device_.identity.size() ? device_.identity.substr(from, 2) : "";
    two.resize(2, '\0');
    return two;
  }
  std::string with_length(const std::string& bytes) const {
    return std::string{request_[0], static_cast<char>(bytes.size())} + bytes;
  }

  Setting coil(unsigned word) const {
    if (word != 0 && word != kCoilOn) throw AnsweredBy{ModbusException::illegal_value};
    return {&settable(spot(true, address_)), word == kCoilOn ? 1.0 : 0.0};
  }
  std::vector<Setting> coils() {
    take_count(kMostBitsWritten, (count() + 7) / 8);
    std::vector<Setting> settings;
    for (int i = 0; i < count_; ++i) {
      const unsigned on = byte_at(request_, 6 + i / 8) >> static_cast<unsigned>(i % 8) & 1U;
      settings.push_back({&settable(spot(true, address_ + i)), static_cast<double>(on)});
    }
    return settings;
  }
  std::vector<Setting> registers(std::string_view data) const {
    std::vector<Setting> settings;
    for (int at = address_; at < address_ + count_;) {
      const auto& here = spot(false, at);
      const Point& point = settable(here);
      const bool half = at != here.place.address || at + here.place.size() > address_ + count_;
      if (half) throw AnsweredBy{ModbusException::illegal_value};
      const double value = value_of(here.place, data.substr(2 * (at - address_)));
      if (!std::isfinite(value)) throw AnsweredBy{ModbusException::illegal_value};
      settings.push_back({&point, value});
      at += here.place.size();
    }
    return settings;
  }
  std::string applied(const std::vector<Setting>& settings) const {
    for (const Setting& one : settings) one.point->write(one.value);
    return std::string(request_.substr(0, 5));
  }

  const RegisterMap& map_;
  const WireDevice& device_;
  std::string_view request_;
  int address_ = 0, count_ = 0;
};

}  // namespace

std::string answer_modbus(const RegisterMap& map, const WireDevice& device,
                          std::string_view request) {
  if (request.empty()) return {};
  if (device.heard) device.heard();
  auto exception = ModbusException::device_failure;
  try {
    return RegisterAnswer(map, device, request).made();
  } catch (const AnsweredBy& end) {
    exception = end.exception;
  } catch (const Refused& refused) {
    if (refused.why() == Refused::Why::out_of_range) exception = ModbusException::illegal_value;
  }
  return exception_answer(byte_at(request, 0), exception);
}

}  // namespace triax::lab
