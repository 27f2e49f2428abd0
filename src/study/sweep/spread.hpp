// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <vector>

namespace triax::study {

/// How some values are spread.
struct Spread {
  double mean = 0, smallest = 0, largest = 0;
  std::optional<double> standard_deviation;  ///< √(Σ(x − mean)²/(n − 1)); nothing for one value
};

/// Nothing without values. Pre-condition: they are finite.
std::optional<Spread> spread_of(const std::vector<double>& values);

}  // namespace triax::study
