// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Quantities that a column can have, from lab/intake/lexicon/*.toml.
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lab/intake/names/unit_names.hpp"

namespace triax::lab {

/// A sign or factor that laboratories use for a quantity.
struct SignHint {
  std::vector<std::string> names;  ///< of columns with these names only; empty: of all
  std::optional<int> sign;         ///< 1 or -1; 0 if the readings decide
  double factor = 1;
  std::string note;
};

/// Another quantity that has the same name, and what decides between the two.
struct SharedName {
  std::string quantity;
  std::vector<std::string> names;  ///< empty: every name of `quantity` is used for this one, too
  /// unit, identity (physics over all rows), cells (what they look like), neighbour (another
  /// column), language (of most headings) or same (both have equal values)
  std::string decided_by;
  std::string rule;
};

struct LexiconQuantity {
  std::string name;  ///< "pore_pressure"
  std::string dimension;
  std::vector<std::string> also;  ///< dimensions of other ways to write it
  std::string unit;  ///< canonical: kPa, mm, mm2, mm3, kN, s, degC; "" for plain numbers
  std::optional<std::pair<double, double>> usual;  ///< lowest and highest value in `unit`
  std::optional<int> decimals;                     ///< of a reading in `unit`
  std::vector<std::string> confused_with;          ///< quantities to compare with
  std::vector<SignHint> sign_hints;
  std::vector<SharedName> shared_names;

  /// True for a dimension that a column of this quantity can have.
  bool can_have(std::string_view other_dimension) const;
};

/// All quantities, by name.
const std::vector<LexiconQuantity>& lexicon_quantities();
/// Null for an unknown name.
const LexiconQuantity* find_lexicon_quantity(std::string_view name);

/// Canonical value = factor * value^power + offset.
struct UnitConversion {
  double factor = 1;
  double offset = 0;
  double power = 1;
};
/// From one unit to another. Pre-condition: they have the same dimension.
UnitConversion unit_conversion(const UnitName& from, const UnitName& to);
/// From a unit to the canonical unit of a quantity. Readings of dials and rings stay as they are.
/// Empty if the dimensions differ: a voltage needs a calibration.
std::optional<UnitConversion> conversion_to_canonical(const LexiconQuantity& quantity,
                                                      const UnitName& unit);
/// The factor of conversion_to_canonical().
std::optional<double> factor_to_canonical(const LexiconQuantity& quantity, const UnitName& unit);

}  // namespace triax::lab
