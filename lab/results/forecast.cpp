// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/forecast.hpp"

#include <array>

#include "lab/base/names.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::lab {
namespace {

constexpr auto kWarningLevels = std::to_array<std::pair<WarningLevel, std::string_view>>(
    {{WarningLevel::none, "none"},
     {WarningLevel::approaching, "approaching"},
     {WarningLevel::imminent, "imminent"},
     {WarningLevel::lost, "lost"}});

/// A plain number is its own unit.
sim::Unit unit_of(Quantity quantity) {
  return sim::find_unit(info(quantity).unit).value_or(sim::Unit{});
}

}  // namespace

double in_field_units(const LeftToOnset& left) {
  return sim::to_field(left.value, unit_of(left.quantity));
}

double from_field_units(Quantity quantity, double value) {
  return sim::to_si(value, unit_of(quantity));
}

std::string_view to_string(WarningLevel level) {
  return name_of<WarningLevel>(level, kWarningLevels);
}
std::optional<WarningLevel> warning_level_from(std::string_view text) {
  return value_of<WarningLevel>(text, kWarningLevels);
}

}  // namespace triax::lab
