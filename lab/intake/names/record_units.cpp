// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/record_units.hpp"

#include <vector>

#include "lab/base/text.hpp"
#include "lab/intake/names/unit_names.hpp"

namespace triax::lab {
namespace {

std::string_view name_of(sim::Dimension dimension) {
  using enum sim::Dimension;
  switch (dimension) {
    case none:
      return "none";
    case time:
      return "time";
    case length:
      return "length";
    case volume:
      return "volume";
    case area:
      return "area";
    case force:
      return "force";
    case pressure:
      return "pressure";
    case angle:
      return "angle";
    case mass:
      return "mass";
    case density:
      return "density";
  }
  return {};
}

}  // namespace

std::optional<sim::Unit> find_record_unit(std::string_view text, sim::Dimension dimension) {
  if (const auto unit = sim::find_unit(text); unit && unit->dimension == dimension) return unit;
  for (const UnitName* unit : find_unit_names(text))
    if (unit->dimension == name_of(dimension) && unit->offset == 0 && unit->power == 1) {
      const auto same = sim::find_unit(unit->name);
      return same ? same : sim::Unit{unit->name, dimension, unit->factor};
    }
  return std::nullopt;
}

std::vector<std::string> record_units(sim::Dimension dimension) {
  std::vector<std::string> names;
  for (const UnitName* unit : units_of(name_of(dimension)))
    if (find_record_unit(unit->name, dimension)) names.push_back(unit->name);
  return names;
}

std::string record_unit_names(sim::Dimension dimension) { return joined(record_units(dimension)); }

}  // namespace triax::lab
