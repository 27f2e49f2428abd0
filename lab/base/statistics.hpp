// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

namespace triax::lab {

/// The middle value, of an even number the upper of the two; NaN of none. Pre-condition: no NaN.
double median(std::vector<double> values);
/// Standard deviation of the population from which they are drawn, √(Σ(x − x̄)²/(n − 1)); NaN of
/// less than two.
double standard_deviation(const std::vector<double>& values);

}  // namespace triax::lab
