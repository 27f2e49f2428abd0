// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The ways to read one column of a table, with the evidence of its heading, unit, sign and range.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/intake/names/lexicon.hpp"

namespace triax::lab {

/// A column as the file has it.
struct ColumnSample {
  std::vector<std::string> headings;  ///< the whole heading, then its lowest line; may be empty
  std::string unit_of_row;            ///< of a row of units, empty if there is none
  std::vector<double> values;         ///< of the sample's rows, NaN where there is none
  double half_unit = 0;               ///< half a unit of the last printed digit
  bool is_number = true;              ///< false for texts, dates and clocks
  std::optional<int> software_sign;   ///< 1 or -1, of the software that wrote the file
};

enum class UnitSource {
  heading,
  row,       ///< of units
  name,      ///< counters and texts have none
  none,      ///< a plain number
  format,    ///< the software that wrote the file
  identity,  ///< only the readings decide
  asked,     ///< nothing decides
};

/// One way to read a column.
struct ColumnReading {
  const LexiconQuantity* quantity = nullptr;  ///< null: not used
  std::string unit;                           ///< as written, or the canonical name
  double factor = 1;                          ///< to the canonical unit
  double offset = 0;                          ///< added after the factor
  int sign = 1;
  UnitSource unit_source = UnitSource::heading;
  std::optional<NameMatch> name;  ///< how the heading names it; nothing: by unit and readings only
  double evidence = 0;            ///< of name, unit, sign and usual range
  /// The cell pressure is the total radial stress.
  bool same_meaning(const ColumnReading& other) const;
};

/// The readings that one column can have, the most likely first; the last one is not used. Never
/// empty.
std::vector<ColumnReading> find_readings(const ColumnSample& column);

/// Evidence against a sign that is unusual for a quantity.
inline constexpr double kOtherSign = -3;

/// Units that a file can mean for a quantity without saying it, the usual one first. Empty for
/// plain numbers other than strains, and for texts.
std::vector<std::string> unsaid_units(const LexiconQuantity& quantity);

/// The group of quantities with the same units that are left out: the dimension, or "strain".
std::string_view unit_group(const LexiconQuantity& quantity);

}  // namespace triax::lab
