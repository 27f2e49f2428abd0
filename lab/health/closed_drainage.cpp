// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/closed_drainage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "lab/health/sensor_limits.hpp"

namespace triax::lab {
namespace {

namespace limits = sensor_limits;

}  // namespace

void ClosedDrainage::open() {
  const double back = back_;
  *this = ClosedDrainage(volume_m3_);
  back_ = back;
}

void ClosedDrainage::add(const Reading& believed, const State& state) {
  mark_ = false;
  look_for_water(believed);
  look_at_pore_pressure(believed, state);
  // What was found before the first of the suspicions is what may have to be kept.
  if (suspicion()) mark_ = false;
  before_ = believed.number;
}

void ClosedDrainage::look_for_water(const Reading& believed) {
  if (!believed.has(Quantity::back_volume) || !(volume_m3_ > 0)) return;
  const double volume = believed[Quantity::back_volume];
  if (stage_ != believed.stage) start_volume_ = volume;
  stage_ = believed.stage;
  const double flowed = volume - start_volume_;
  if (std::fabs(flowed) <= limits::kClosedVolume * volume_m3_) {
    wet_ = 0;
    return;
  }
  if (++wet_ == 1) dry_until_ = before_;
  if (wet_ < 2 || doubt_) return;
  // A gauge that comes late shows the water after the pore pressure did.
  doubt_ = Doubt{returning_ ? std::min(turned_, dry_until_) : dry_until_,
                 fmt::format("water flows although the valve is closed ({:.0f} mm3): the valve "
                             "does not close, there is a leak, or the volume gauge drifts",
                             flowed * 1e9)};
}

void ClosedDrainage::look_at_pore_pressure(const Reading& believed, const State& state) {
  if (believed.has(Quantity::back_pressure)) back_ = believed[Quantity::back_pressure];
  if (!believed.has(Quantity::pore_pressure)) return;
  const double pore = believed[Quantity::pore_pressure];
  if (std::isnan(back_)) back_ = pore;
  const double total_p = believed[Quantity::cell_pressure] + state.q / 3;
  if (!std::exchange(shut_, true)) {
    mark_ = true;
    start_ = believed.number - 1;
    start_difference_ = pore - back_;
    start_pore_ = pore;
  }
  if (!std::isnan(start_volume_) && wet_ == 0)
    largest_alone_ = std::max(largest_alone_, std::fabs(pore - start_pore_));
  if (std::isnan(start_p_) || std::isnan(start_p_eff_)) {
    start_p_eff_ = state.p_eff;
    start_p_ = total_p;
  }
  if (std::isnan(start_p_) || !(start_p_eff_ > 0)) return;
  const double size = std::fabs(pore - back_ - start_difference_);
  look_for_return(size, total_p, believed.number);
  look_for_silence(total_p);
}

void ClosedDrainage::look_for_return(double size, double total_p, std::int64_t number) {
  if (size >= largest_) {
    if (size > largest_ && largest_ >= limits::kLeft * start_p_eff_) returned_.reset();
    largest_ = size;
    returning_ = false;
    back_from_.reset();
    near_.reset();
    return;
  }
  if (largest_ < limits::kLeft * start_p_eff_) return;
  if (size > limits::kLeaves * largest_) returned_.reset();
  if (size < limits::kShrinks * largest_ && !std::exchange(returning_, true)) {
    mark_ = true;
    turned_ = before_;
  }
  if (size > limits::kGrows * largest_) returning_ = false;
  if (size > limits::kReturned * largest_)
    back_from_.reset();
  else if (!back_from_)
    back_from_ = number;
  const bool rests =
      back_from_ &&
      number - *back_from_ >= std::max<std::int64_t>(limits::kRests.count(), *back_from_ - turned_);
  if ((!is_silent_near(size, total_p) && !rests) || returned_) return;
  returned_ = Doubt{
      turned_, fmt::format("the pore pressure returned to the back pressure, from {:.1f} kPa away, "
                           "and stays there: the valve is open",
                           largest_ / 1e3)};
}

bool ClosedDrainage::is_silent_near(double size, double total_p) {
  const double loading = limits::kLoading * start_p_eff_;
  if (std::isnan(total_p)) return false;
  if (size > limits::kLeaves * largest_) {
    near_.reset();
  } else if (!near_ || std::fabs(size - near_->size) > limits::kAnswer * loading) {
    near_ = Answer{size, total_p};
  }
  return near_ && std::fabs(total_p - near_->total_p) >= loading;
}

void ClosedDrainage::look_for_silence(double total_p) {
  const double loading = std::fabs(total_p - start_p_);
  if (answered_ || !(loading >= limits::kLoading * start_p_eff_)) return;
  answered_ = std::max(largest_, largest_alone_) >=
              std::min(limits::kAnswer * loading, limits::kLeft * start_p_eff_);
  if (answered_) {
    silent_.reset();
  } else if (!silent_) {
    silent_ = Doubt{
        start_,
        fmt::format("the pore pressure stayed at the back pressure while the mean total stress "
                    "changed by {:.1f} kPa: the valve is open, or the specimen is not saturated",
                    loading / 1e3)};
  }
}

}  // namespace triax::lab
