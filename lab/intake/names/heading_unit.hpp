// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <functional>
#include <vector>

#include "lab/intake/names/unit_names.hpp"

namespace triax::lab {

struct NameAndUnit {
  QString name;
  QString unit;  ///< as written, empty if none
};

/// Separates the unit of a heading or label of repair_heading(): "Pore (kPa)_value" is "Pore_value"
/// and "kPa". The last bracket that contains a unit counts. Without such a bracket, the unit is
/// behind a separator of normalise.toml. `is_name(name, units)` is true if a text is the name of
/// something that can have one of the units; with no units, if the whole text is a name, which then
/// has no unit. Behind a text that is no name only a unit counts that is nothing else ("mm", not
/// "t").
NameAndUnit split_unit(
    const QString& repaired,
    const std::function<bool(const QString&, const std::vector<const UnitName*>&)>& is_name);

}  // namespace triax::lab
