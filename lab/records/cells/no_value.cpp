// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/cells/no_value.hpp"

#include <algorithm>
#include <array>

namespace triax::lab {
namespace {

constexpr double kMotion = 0.05;  ///< of the code: step between two readings of a live channel
constexpr double kBeyondAnyUnit = 1e15;

/// 999, 999.9, 9999.99: a power of ten less one unit of the last digit.
bool is_all_nines(double magnitude) {
  const double power = std::pow(10, std::ceil(std::log10(magnitude)));
  const double unit = power - magnitude;
  constexpr std::array kUnits{1.0, 0.1, 0.01, 0.001};
  return std::ranges::any_of(kUnits, [&](double u) { return std::fabs(unit - u) < 1e-3 * u; });
}

}  // namespace

bool is_no_value_code(double number) {
  const double magnitude = std::fabs(number);
  if (!may_be_no_value(number)) return false;
  if (magnitude >= kBeyondAnyUnit) return true;
  constexpr std::array kCodes{6999.0,       -6999.0,       7999.0,      -7999.0, -8888.0,
                              -7777.0,      -999.25,       -32768.0,    32767.0, 65535.0,
                              2147483647.0, -2147483648.0, 4294967295.0};
  if (std::ranges::find(kCodes, number) != kCodes.end()) return true;
  if (number < 0) return is_all_nines(magnitude);
  return magnitude >= 9999 && magnitude == std::round(magnitude) && is_all_nines(magnitude);
}

bool means_no_value(double number, double previous) {
  return is_no_value_code(number) && !(std::fabs(number - previous) <= kMotion * std::fabs(number));
}

}  // namespace triax::lab
