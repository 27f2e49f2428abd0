// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/change_point.hpp"

#include <algorithm>
#include <cmath>

namespace triax::lab {

bool ChangePoint::add(double value, double error, double weight) {
  constexpr double kFloor = 0.01;  // no error estimate from seven blocks is better than that
  if (error > kUseless) return sum_ == 0;
  const double precision = weight / std::max(error * error, kFloor * kFloor);
  sum_ += value * precision;
  if (sum_ >= 0) {
    clear();
    return true;
  }
  precision_ += precision;
  weight_ += weight;
  return false;
}

bool ChangePoint::found() const {
  return lasted() && sum_ < -kSignificance * std::sqrt(precision_);
}

}  // namespace triax::lab
