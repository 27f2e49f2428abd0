// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A number that defines a result, with what `triax about --rules` prints of it.
#include <string_view>

namespace triax::lab {

/// A limit of an assessment, a sensor or a warning. It is its value wherever a number is needed.
struct Limit {
  std::string_view name;
  double value = 0;              ///< SI, a fraction where the unit is %
  std::string_view unit;         ///< as printed: "%", "kPa", "readings"; "" for a ratio
  std::string_view reason;       ///< why this value
  std::string_view origin = {};  ///< standard, publication or decision; empty: triax
  constexpr operator double() const { return value; }  // NOLINT(google-explicit-constructor)
  constexpr int count() const { return static_cast<int>(value); }  ///< of readings, changes, ...
};

}  // namespace triax::lab
