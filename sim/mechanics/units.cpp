// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mechanics/units.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace triax::sim {
namespace {

using enum Dimension;

// First spelling of each row is the canonical name.
constexpr auto kUnits = std::to_array<Unit>({
    {"", none, 1},
    {"-", none, 1},
    {"%", none, 1e-2},
    {"pct", none, 1e-2},
    {"percent", none, 1e-2},
    {"s", time, 1},
    {"sec", time, 1},
    {"ms", time, 1e-3},
    {"min", time, 60},
    {"h", time, 3600},
    {"hr", time, 3600},
    {"day", time, 86400},
    {"m", length, 1},
    {"cm", length, 1e-2},
    {"mm", length, 1e-3},
    {"um", length, 1e-6},
    {"in", length, 0.0254},
    {"m2", area, 1},
    {"cm2", area, 1e-4},
    {"mm2", area, 1e-6},
    {"mm^2", area, 1e-6},
    {"mm²", area, 1e-6},
    {"m3", volume, 1},
    {"l", volume, 1e-3},
    {"ml", volume, 1e-6},
    {"cm3", volume, 1e-6},
    {"cc", volume, 1e-6},
    {"mm3", volume, 1e-9},
    {"mm^3", volume, 1e-9},
    {"mm³", volume, 1e-9},
    {"N", force, 1},
    {"kN", force, 1e3},
    {"MN", force, 1e6},
    {"kgf", force, 9.80665},
    {"lbf", force, 4.4482216152605},
    {"Pa", pressure, 1},
    {"kPa", pressure, 1e3},
    {"kN/m2", pressure, 1e3},
    {"kN/m^2", pressure, 1e3},
    {"kN/m²", pressure, 1e3},
    {"MPa", pressure, 1e6},
    {"MN/m2", pressure, 1e6},
    {"bar", pressure, 1e5},
    {"psi", pressure, 6894.757293168},
    {"kgf/cm2", pressure, 98066.5},
    {"kg/cm2", pressure, 98066.5},
    {"rad", angle, 1},
    {"deg", angle, 0.017453292519943295},
    {"°", angle, 0.017453292519943295},
    {"kg", mass, 1},
    {"g", mass, 1e-3},
    {"Mg/m3", density, 1e3},
    {"Mg/m³", density, 1e3},
    {"Mg/m^3", density, 1e3},
    {"t/m3", density, 1e3},
    {"g/cm3", density, 1e3},
    {"g/cc", density, 1e3},
    {"kg/m3", density, 1},
});

std::ptrdiff_t decimal_length(double value) {
  std::array<char, 64> text{};
  return std::to_chars(text.data(), text.data() + text.size(), value).ptr - text.data();
}

}  // namespace

std::optional<Unit> find_unit(std::string_view name) {
  for (const Unit& unit : kUnits)
    if (unit.name == name) return unit;
  return std::nullopt;
}

double to_field(double si, const Unit& unit) {
  if (!std::isfinite(si)) return si;
  const double nearest = si / unit.scale;
  constexpr double kInf = std::numeric_limits<double>::infinity();
  double best = nearest;
  std::ptrdiff_t best_length = std::numeric_limits<std::ptrdiff_t>::max();
  for (const double candidate :
       {nearest, std::nextafter(nearest, kInf), std::nextafter(nearest, -kInf)}) {
    if (to_si(candidate, unit) != si) continue;
    const auto length = decimal_length(candidate);
    if (length < best_length) {
      best = candidate;
      best_length = length;
    }
  }
  return best;
}

}  // namespace triax::sim
