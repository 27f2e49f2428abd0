// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/rate_check.hpp"

#include <fmt/format.h>

#include <cmath>

namespace triax::lab {
namespace {

constexpr double kLeast = 1e-3;   // share of p′ from which a maximum is kept
constexpr double kGrowth = 1.08;  // of one kept maximum over the one before

}  // namespace

void RateCheck::add(const Reading& reading, const State& state, bool drained_shear,
                    std::optional<double> rest_difference) {
  if (!drained_shear) {
    count_ = 0;
    return;
  }
  const double whole = reading[Quantity::pore_pressure] - reading[Quantity::back_pressure];
  if (!std::isfinite(whole) || !std::isfinite(state.p_eff)) return;
  if (!at_start_) at_start_ = whole;
  const double difference = whole - rest_difference.value_or(*at_start_);
  if (count_ == 0) difference_sum_ = p_sum_ = 0;
  difference_sum_ += difference;
  p_sum_ += state.p_eff;
  if (++count_ < kMean) return;
  count_ = 0;
  if (!first_) first_ = reading.number;
  if (!(p_sum_ > 0)) return;
  const double ratio = std::fabs(difference_sum_) / p_sum_;
  const double last = kept_ > 0 ? maxima_[kept_ - 1].ratio : 0;
  if (ratio < kLeast || ratio < last * kGrowth || kept_ == maxima_.size()) return;
  maxima_[kept_++] = {reading.number, ratio, difference_sum_ / kMean};
}

std::optional<Check> RateCheck::check(std::optional<std::int64_t> before) const {
  if (!first_ || (before && *before <= *first_)) return std::nullopt;
  Maximum largest;
  for (std::size_t i = 0; i < kept_ && (!before || maxima_[i].reading < *before); ++i)
    largest = maxima_[i];
  const bool ok = largest.ratio <= kLimit;
  std::string note = "in drained shear the pore pressure followed the back pressure";
  if (!ok)
    note = fmt::format(
        "at reading {} the pore pressure was {:.2f} kPa {} the back pressure, {:.1f} % of p': the "
        "rate was too high for the drainage, a line is blocked, or one of the two transducers "
        "drifted",
        largest.reading, std::fabs(largest.difference_pa) / 1e3,
        largest.difference_pa > 0 ? "above" : "below", largest.ratio * 100);
  return Check{.kind = CheckKind::rate,
               .measured = largest.ratio,
               .limit = kLimit,
               .ok = ok,
               .note = std::move(note)};
}

}  // namespace triax::lab
