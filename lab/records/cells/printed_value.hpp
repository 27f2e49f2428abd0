// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Values as a table prints them: rounded to their last digit, and what follows from them.
#include <cmath>
#include <string_view>

#include "lab/results/reading.hpp"

namespace triax::lab {

/// Half a unit of the last digit of a cell that is a number, in the unit of the cell: 0.0005 for
/// "1.234", 0.5 for "12", 50 for "1.2e3". The decimal mark is a point or a comma.
double half_unit_of(std::string_view cell);

/// A printed value, or what is computed from printed values: the true value is within `error` of
/// `value`. The operators propagate the errors as sums of absolute values, which is what correct
/// rounding can amount to. A value that is missing makes the result missing.
struct PrintedValue {
  double value = kMissing;
  double error = 0;

  /// True where both are known and no true value agrees with both. Programs that compute in single
  /// precision print digits that they do not have: 2^-21 of `scale` is allowed besides, the largest
  /// of the values that these were computed from.
  bool contradicts(const PrintedValue& other, double scale) const {
    return std::fabs(value - other.value) > error + other.error + 0x1p-21 * scale;
  }
};

inline PrintedValue operator+(const PrintedValue& a, const PrintedValue& b) {
  return {a.value + b.value, a.error + b.error};
}
inline PrintedValue operator-(const PrintedValue& a, const PrintedValue& b) {
  return {a.value - b.value, a.error + b.error};
}
inline PrintedValue operator*(double factor, const PrintedValue& a) {
  return {factor * a.value, std::fabs(factor) * a.error};
}
inline PrintedValue operator*(const PrintedValue& a, const PrintedValue& b) {
  return {a.value * b.value,
          std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error};
}

}  // namespace triax::lab
