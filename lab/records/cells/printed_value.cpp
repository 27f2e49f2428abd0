// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/cells/printed_value.hpp"

#include <array>

#include "lab/base/text.hpp"

namespace triax::lab {

double half_unit_of(std::string_view cell) {
  constexpr std::array<double, 16> kHalfUnits{0.5e0,   0.5e-1,  0.5e-2,  0.5e-3, 0.5e-4,  0.5e-5,
                                              0.5e-6,  0.5e-7,  0.5e-8,  0.5e-9, 0.5e-10, 0.5e-11,
                                              0.5e-12, 0.5e-13, 0.5e-14, 0.5e-15};
  std::size_t end = 0, mark = std::string_view::npos;  // of the digits
  for (; end < cell.size() && cell[end] != 'e' && cell[end] != 'E'; ++end)
    if (cell[end] == '.' || cell[end] == ',') mark = end;
  const std::size_t decimals = mark == std::string_view::npos ? 0 : end - mark - 1;
  if (end == cell.size() && decimals < kHalfUnits.size()) return kHalfUnits[decimals];
  auto exponent = end == cell.size() ? "0" : cell.substr(end + 1);
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  const double power = whole_text_as<int>(exponent).value_or(0) - static_cast<double>(decimals);
  return 0.5 * std::pow(10, power);
}

}  // namespace triax::lab
