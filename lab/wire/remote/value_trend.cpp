// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/value_trend.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace triax::lab {

double ValueTrend::off(double value) const {
  if (!value_) return std::fabs(value);
  const double next = *value_ + std::min(scans_, kMaxScans) * change_;
  return std::max({std::min(*value_, next) - value, value - std::max(*value_, next), 0.0});
}

double ValueTrend::tolerance() const {
  auto offs = offs_;
  std::nth_element(offs.begin(), offs.begin() + (kRank - 1), offs.end(), std::greater<>());
  return std::max(kFactor * offs[kRank - 1], kDigits * std::fabs(value_.value_or(0)));
}

bool ValueTrend::expects(double value) const {
  if (std::isinf(value) || at_end_ != 0) return value == at_end_;
  return value_ && scans_ <= kMaxScans && off(value) <= tolerance();
}

bool ValueTrend::confirms(double value, double before) const {
  if (std::isinf(value) || std::isinf(before)) return value == before;
  return std::fabs(value - before) <= std::max(tolerance(), off(value) / 2);
}

void ValueTrend::start(double value, double noise) {
  value_ = value;
  for (; count_ < kRank; ++count_) offs_[count_] = 2 * noise;  // two values differ by both noises
}

void ValueTrend::accept(double value) {
  at_end_ = std::isinf(value) ? value : 0;
  if (at_end_ != 0) return;
  if (value_ && scans_ == 1) offs_[count_++ % kWindow] = off(value);
  change_ = value_ ? (value - *value_) / scans_ : 0;
  value_ = value;
  scans_ = 1;
}

}  // namespace triax::lab
