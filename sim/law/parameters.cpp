// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/law/parameters.hpp"

#include <array>
#include <cmath>

#include "sim/mechanics/units.hpp"

namespace triax::sim {

std::string short_number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

std::string Range::words() const {
  std::string low, high;
  if (std::isfinite(above)) low = "above " + short_number(above);
  if (std::isfinite(at_least)) low = "at least " + short_number(at_least);
  if (std::isfinite(below)) high = "below " + short_number(below);
  if (std::isfinite(at_most)) high = "at most " + short_number(at_most);
  if (low.empty() && high.empty()) return "a finite number";
  return low + (low.empty() || high.empty() ? "" : " and ") + high;
}

double unit_scale(std::string_view unit) {
  if (unit.empty()) return 1;
  if (const auto known = find_unit(unit)) return known->scale;
  throw std::logic_error("no unit " + std::string(unit));
}

void check_parameter(const ParameterDescription& d, double value) {
  if (std::isfinite(value) && d.range.holds(value)) return;
  throw std::invalid_argument(d.key + " is " + short_number(value) + ", must be " +
                              d.range.words());
}

}  // namespace triax::sim
