// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/consolidation_end.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace triax::lab {
namespace {

constexpr double kLastShare = 0.1;    // of the stage
constexpr double kLeastTime_s = 60;   // over which a rate is taken
constexpr std::int64_t kFading = 16;  // readings, at most
constexpr double kHour_s = 3600;

}  // namespace

void ConsolidationEnd::add(const Reading& reading, const State& state, bool consolidation,
                           double volume_m3) {
  if (!consolidation) return;
  if (stage_ != reading.stage) *this = ConsolidationEnd();
  stage_ = reading.stage;
  volume_m3_ = volume_m3;
  if (reading.has(Quantity::back_volume)) {
    if (std::isnan(reading.time_s)) timed_ = false;
    keep({reading.time_s, reading[Quantity::back_volume]});
  }
  const double difference = reading[Quantity::pore_pressure] - reading[Quantity::back_pressure];
  if (!std::isfinite(difference) || !std::isfinite(state.p_eff)) return;
  // Of a stage with few readings, the earlier ones are from before the pressure dissipated.
  const auto last_readings =
      static_cast<std::int64_t>(kLastShare * static_cast<double>(++differences_));
  const double weight =
      1.0 / static_cast<double>(std::clamp<std::int64_t>(last_readings, 1, kFading));
  difference_ += weight * (difference - difference_);
  p_eff_ += weight * (state.p_eff - p_eff_);
}

void ConsolidationEnd::keep(const Point& point) {
  last_ = point;
  if (kept_ > 0 && ++skipped_ < stride_) return;
  skipped_ = 0;
  if (kept_ == points_.size()) {
    for (std::size_t i = 0; i < kept_ / 2; ++i) points_[i] = points_[2 * i];
    kept_ /= 2;
    stride_ *= 2;
  }
  points_[kept_++] = point;
}

std::optional<double> ConsolidationEnd::difference() const {
  if (differences_ == 0) return std::nullopt;
  return difference_;
}

std::optional<double> ConsolidationEnd::rate_pct_per_h() const {
  if (!timed_ || kept_ < 2 || !(volume_m3_ > 0)) return std::nullopt;
  const double span = std::max(kLastShare * (last_.time_s - points_[0].time_s), kLeastTime_s);
  const auto* from = points_.data();
  for (std::size_t i = 0; i < kept_ && last_.time_s - points_[i].time_s >= span; ++i)
    from = &points_[i];
  const double lapse = last_.time_s - from->time_s;
  if (!(lapse > 0)) return std::nullopt;
  return std::fabs(last_.volume - from->volume) / volume_m3_ / lapse * kHour_s * 100;
}

std::vector<Check> ConsolidationEnd::checks() const {
  std::vector<Check> all;
  if (const auto rate = rate_pct_per_h()) {
    const bool ok = *rate <= kRateLimit_pct_per_h;
    all.push_back(
        {.kind = CheckKind::consolidation,
         .measured = rate,
         .limit = kRateLimit_pct_per_h,
         .ok = ok,
         .note = fmt::format(
             "at the end of consolidation the volume changed by {:.3g} % per hour{}", *rate,
             ok ? "" : ": consolidation was not complete, or the back-pressure controller leaks")});
  }
  if (differences_ > 0 && p_eff_ > 0) {
    const double ratio = std::fabs(difference_) / p_eff_;
    const bool ok = ratio <= kDifferenceLimit;
    all.push_back({.kind = CheckKind::zero_difference,
                   .measured = ratio,
                   .limit = kDifferenceLimit,
                   .ok = ok,
                   .note = fmt::format(
                       "at the end of consolidation the pore pressure was {:.2f} kPa {} the back "
                       "pressure{}",
                       std::fabs(difference_) / 1e3, difference_ < 0 ? "below" : "above",
                       ok ? ""
                          : ": it had not dissipated, the valve was not open, or one of the two "
                            "transducers has a zero error")});
  }
  return all;
}

}  // namespace triax::lab
