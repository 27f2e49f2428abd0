// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/row_direction.hpp"

#include <algorithm>

namespace triax::lab {
namespace {

/// Noise turns a step now and then.
bool rows_run_back(std::int64_t back, std::int64_t forward) {
  constexpr std::int64_t kMin_back_per_forward = 20;
  return back + 1 >= RowDirection::kMin_rows && back >= kMin_back_per_forward * forward;
}

}  // namespace

void RowDirection::add(double value) {
  if (std::isnan(value)) return;
  if (std::isnan(first_)) {
    first_ = last_ = value;
    return;
  }
  if (value > last_) ++forward_;
  if (value < last_) ++back_;
  largest_later_ = std::max(largest_later_, std::fabs(value));
  last_ = value;
}

bool RowDirection::runs_back() const { return rows_run_back(back_, forward_); }

bool RowDirection::runs_to_zero() const {
  constexpr double kNoise_fraction = 0.01;
  const double largest = std::fabs(first_);
  const bool is_to_zero = largest >= (1 - kNoise_fraction) * largest_later_ &&
                          std::fabs(last_) <= kLast_fraction * largest;
  return is_to_zero &&
         (first_ > 0 ? rows_run_back(back_, forward_) : rows_run_back(forward_, back_));
}

}  // namespace triax::lab
