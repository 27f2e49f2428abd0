// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Statistics of columns for the evidence of identities (identities.hpp).
#include <cstddef>
#include <span>
#include <vector>

#include "lab/intake/identities.hpp"

namespace triax::lab {

using SeriesSpan = std::span<const Series* const>;

/// With fewer rows there is no evidence.
inline constexpr std::size_t kMinRows = 3;

/// 0 for no values.
double root_mean_square(const std::vector<double>& values);
/// The following two need at least one value.
double mean_of(const std::vector<double>& values);
/// Standard deviation, of all values.
double variation(std::vector<double> values);
/// True if no series lacks the value of the row.
bool is_complete(SeriesSpan series, std::size_t row);
/// The values without NaN.
std::vector<double> known_values(const Series& series);
/// Largest magnitude; 0 for no values.
double largest(const std::vector<double>& values);

}  // namespace triax::lab
