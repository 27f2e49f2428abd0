// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/modbus/register_value.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "lab/wire/modbus/pdu.hpp"

namespace triax::lab {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
constexpr unsigned kNoSigned = 0x8000U, kNoUnsigned = 0xFFFFU;
constexpr double kMostSigned = 32767, kMostUnsigned = 65534;

double least(RegisterForm form) { return form == RegisterForm::int16 ? -kMostSigned : 0; }
double most(RegisterForm form) { return form == RegisterForm::int16 ? kMostSigned : kMostUnsigned; }

}  // namespace

std::string registers_of(const PointRegister& place, double value) {
  std::string bytes;
  if (place.size() == 2) {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    const bool low_first = place.form == RegisterForm::float32_low_first;
    put_word(bytes, low_first ? bits : bits >> 16U);
    put_word(bytes, low_first ? bits >> 16U : bits);
  } else if (std::isnan(value)) {
    put_word(bytes, place.form == RegisterForm::int16 ? kNoSigned : kNoUnsigned);
  } else {
    const double steps =
        std::clamp(std::round(value / place.factor), least(place.form), most(place.form));
    put_word(bytes, static_cast<unsigned>(static_cast<int>(steps)));
  }
  return bytes;
}

double value_of(const PointRegister& place, std::string_view bytes) {
  const unsigned first = word_at(bytes, 0);
  if (place.size() == 2) {
    const unsigned second = word_at(bytes, 2);
    const bool low_first = place.form == RegisterForm::float32_low_first;
    const std::uint32_t bits = low_first ? second << 16U | first : first << 16U | second;
    return static_cast<double>(std::bit_cast<float>(bits));
  }
  if (place.form == RegisterForm::uint16)
    return first == kNoUnsigned ? kNoValue : first * place.factor;
  return first == kNoSigned ? kNoValue : static_cast<std::int16_t>(first) * place.factor;
}

bool can_hold(const PointRegister& place, double value) {
  if (place.is_bit()) return value == 0 || value == 1;
  if (place.size() == 2)
    return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
  const double steps = std::round(value / place.factor);
  return steps >= least(place.form) && steps <= most(place.form);
}

}  // namespace triax::lab
