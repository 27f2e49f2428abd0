// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/series_math.hpp"

#include <algorithm>
#include <cmath>

namespace triax::lab {

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double variation(std::vector<double> values) {
  const double mean = mean_of(values);
  for (double& value : values) value -= mean;
  return root_mean_square(values);
}

bool is_complete(SeriesSpan series, std::size_t row) {
  return std::ranges::none_of(series,
                              [row](const Series* one) { return std::isnan(one->values[row]); });
}

std::vector<double> known_values(const Series& series) {
  std::vector<double> out;
  for (const double value : series.values)
    if (!std::isnan(value)) out.push_back(value);
  return out;
}

double largest(const std::vector<double>& values) {
  double out = 0;
  for (const double value : values) out = std::max(out, std::fabs(value));
  return out;
}

}  // namespace triax::lab
