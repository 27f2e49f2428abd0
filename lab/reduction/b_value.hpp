// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "lab/results/reading.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// Skempton's B = Δu/Δσ_c over a B-check stage: from its first reading to its last, undrained, at
/// constant q.
class BValue {
 public:
  static constexpr double kLimit = 0.96;  ///< Darve et al. (2007), section 2.2

  void add(const Reading& reading, bool in_b_check);
  /// Of the latest B check whose cell pressure moved by 5 kPa or more.
  std::optional<double> value() const { return value_; }
  /// Pre-condition: value().
  Check check() const;

 private:
  std::optional<int> stage_;
  double cell_start_ = 0, pore_start_ = 0;
  std::optional<double> value_;
};

}  // namespace triax::lab
