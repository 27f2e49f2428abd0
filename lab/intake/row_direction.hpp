// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>
#include <cstdint>

namespace triax::lab {

/// How one value runs from row to row: forward, or back as in a table whose last reading is in its
/// first row.
class RowDirection {
 public:
  static constexpr double kLast_fraction = 0.05;
  static constexpr int kMin_rows = 5;

  /// NaN: the row has no value.
  void add(double value);
  bool is_empty() const { return std::isnan(first_); }
  double first() const { return first_; }
  double last() const { return last_; }
  /// The value decreases in almost all steps (of a time: the rows are reversed).
  bool runs_back() const;
  /// The value begins at its largest distance from zero and runs back, but for noise, to
  /// kLast_fraction of it or less (of a strain: the rows are reversed, for a specimen that is
  /// unloaded keeps more).
  bool runs_to_zero() const;

 private:
  double first_ = NAN, last_ = NAN;
  std::int64_t forward_ = 0, back_ = 0;  ///< steps
  double largest_later_ = 0;             ///< absolute value, after the first row
};

}  // namespace triax::lab
