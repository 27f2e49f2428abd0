// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "lab/results/quantity.hpp"

namespace triax::lab {

inline constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
/// For a channel that a record need not have, where nothing known means that nothing moved.
inline double or_zero(double value) { return std::isnan(value) ? 0.0 : value; }

/// One scan of all channels at one time, as the instruments (or the file) gave it, in SI.
/// Never altered once made; always stored. A cell that is missing is NaN here and null outside.
struct Reading {
  std::int64_t number = 0;   ///< counts from 0 within the test
  double time_s = kMissing;  ///< strictly increasing test time; missing in a record without time
  int stage = 1;             ///< number of the stage, see RecordHeader::stages
  std::array<double, kQuantityCount> si{};
  std::int64_t line = 0;  ///< line of the file it came from, 0 if from no file

  Reading() { si.fill(kMissing); }
  double operator[](Quantity q) const { return si[index(q)]; }
  double& operator[](Quantity q) { return si[index(q)]; }
  bool has(Quantity q) const { return !std::isnan(si[index(q)]); }
};

}  // namespace triax::lab
