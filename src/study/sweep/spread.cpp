// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sweep/spread.hpp"

#include <algorithm>
#include <cmath>

namespace triax::study {

std::optional<Spread> spread_of(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  const auto n = static_cast<double>(values.size());
  Spread spread;
  double squares = 0;
  for (const double v : values) spread.mean += v / n;
  for (const double v : values) squares += (v - spread.mean) * (v - spread.mean);
  const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
  spread.smallest = *smallest;
  spread.largest = *largest;
  if (values.size() > 1) spread.standard_deviation = std::sqrt(squares / (n - 1));
  return spread;
}

}  // namespace triax::study
