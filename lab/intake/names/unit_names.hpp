// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <string>
#include <string_view>
#include <vector>

namespace triax::lab {

/// A unit as laboratories write it, from lab/intake/units.toml. In the SI unit of its dimension a
/// value is factor * value^power + offset; of a plain number, 0.01 for %.
struct UnitName {
  std::string name;       ///< as in sim/mechanics/units.cpp where that has the unit
  std::string dimension;  ///< "pressure", "length", "none" for plain numbers, ...
  double factor = 1;
  double offset = 0;
  double power = 1;
  bool is_ambiguous = false;    ///< the spelling that was found can have another meaning
  std::string decided_by;       ///< what resolves the ambiguity
  bool can_end_heading = true;  ///< also without brackets, as in "Pore pressure kPa"
};

/// Units that have this spelling: "KN/m²", "(kPa)". Empty for a text that is no unit. More than one
/// for an ambiguous spelling: "kg" is a force or a mass.
std::vector<const UnitName*> find_unit_names(std::string_view text);
/// The same for a text of repair_heading().
std::vector<const UnitName*> find_units(const QString& repaired);

/// All units of a dimension, each once.
std::vector<const UnitName*> units_of(std::string_view dimension);

}  // namespace triax::lab
