// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/diggs/diggs_units.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

using enum sim::Dimension;

constexpr double kFoot = 0.3048, kInch = 0.0254, kPoundForce = 4.4482216152605;

/// Symbols beside those that records use anyway (sim::find_unit).
constexpr auto kDiggsUnits = std::to_array<sim::Unit>({
    {"Euc", none, 1},
    {"m/m", none, 1},
    {"mm/mm", none, 1},
    {"in/in", none, 1},
    {"d", time, 86400},
    {"second", time, 1},
    {"minute", time, 60},
    {"hour", time, 3600},
    {"ft", length, kFoot},
    {"ft2", area, kFoot* kFoot},
    {"in2", area, kInch* kInch},
    {"ft3", volume, kFoot* kFoot* kFoot},
    {"in3", volume, kInch* kInch* kInch},
    {"L", volume, 1e-3},
    {"mL", volume, 1e-6},
    {"gf", force, 9.80665e-3},
    {"klbf", force, 1e3 * kPoundForce},
    {"lbf/in2", pressure, 6894.757293168},
    {"lbf/ft2", pressure, kPoundForce / (kFoot * kFoot)},
    {"psf", pressure, kPoundForce / (kFoot * kFoot)},
    {"klbf/ft2", pressure, 1e3 * kPoundForce / (kFoot * kFoot)},
    {"ksf", pressure, 1e3 * kPoundForce / (kFoot * kFoot)},
    {"tonfUS/ft2", pressure, 2e3 * kPoundForce / (kFoot * kFoot)},
    {"tsf", pressure, 2e3 * kPoundForce / (kFoot * kFoot)},
    {"N/m2", pressure, 1},
    {"N/mm2", pressure, 1e6},
    {"dega", angle, std::numbers::pi / 180},
});

}  // namespace

std::optional<sim::Unit> find_diggs_unit(std::string_view uom) {
  uom = trimmed(uom);
  if (const auto known = sim::find_unit(uom)) return known;
  const auto* const found = std::ranges::find(kDiggsUnits, uom, &sim::Unit::name);
  if (found == kDiggsUnits.end()) return std::nullopt;
  return *found;
}

}  // namespace triax::lab
