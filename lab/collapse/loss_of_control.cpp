#include "lab/collapse/loss_of_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/collapse/instant.hpp"

namespace triax::lab {

void LossOfControl::start_stage(const StageInfo* stage) {
  const auto found = std::move(finding_);
  *this = LossOfControl();
  finding_ = found;
  control_ = stage ? stage->control : AxialControl::unknown;
}

void LossOfControl::add(const State& state, bool has_time) {
  const bool watched = control_ == AxialControl::constant_q || control_ == AxialControl::load;
  if (!watched || finding_) return;
  ++count_;
  if (control_ == AxialControl::constant_q) check_held_q(state, has_time);
  if (!finding_) check_burst(state, has_time);
}

void LossOfControl::check_held_q(const State& state, bool has_time) {
  const double q = std::fabs(state.q);  // in extension as in compression
  if (count_ <= kReference) {
    const double change = q - q_mean_;
    q_mean_ += change / static_cast<double>(count_);
    q_square_ += change * (q - q_mean_);
    return;
  }
  const double deviation = std::sqrt(q_square_ / (kReference - 1));
  if (q > q_mean_ - std::max(0.05 * q_mean_, 6 * deviation)) {
    below_ = 0;
    return;
  }
  if (below_++ == 0) first_below_ = state;
  if (below_ < 3) return;
  finding_ = Finding{instant_of(first_below_, has_time),
                     fmt::format("q was held at {:.2f} ± {:.2f} kPa and fell to {:.2f} kPa",
                                 q_mean_ / 1e3, deviation / 1e3, q / 1e3)};
}

void LossOfControl::check_burst(const State& state, bool has_time) {
  // Per second where there is time, so that a logger that slows down makes no burst; else per
  // reading.
  const auto rate = [has_time](const State& a, const State& b) {
    const double lapse =
        has_time ? b.time_s - a.time_s : static_cast<double>(b.reading - a.reading);
    return std::fabs(b.strain.axial - a.strain.axial) / lapse;
  };
  // recent_ holds the last few states, oldest first; what leaves it becomes the rate so far.
  if (count_ > kRecent) {
    const double weight = 1.0 / static_cast<double>(std::min<std::int64_t>(++steps_, 64));
    mean_rate_ += weight * (rate(recent_[0], recent_[1]) - mean_rate_);
  }
  std::shift_left(recent_.begin(), recent_.end(), 1);
  recent_.back() = state;
  if (steps_ < kReference) return;

  constexpr double kLeastRise = 1e-3;
  const double rise = std::fabs(state.strain.axial - recent_.front().strain.axial);
  const double burst = rate(recent_.front(), state);
  if (rise < kLeastRise || burst < 10 * mean_rate_) return;
  // The burst began where the steps first left what they had been.
  std::size_t start = 0;
  while (start + 2 < recent_.size() && rate(recent_[start], recent_[start + 1]) < 5 * mean_rate_)
    ++start;
  finding_ = Finding{instant_of(recent_[start], has_time),
                     fmt::format("axial strain ran from {:.3f} % to {:.3f} % within {} readings{}",
                                 recent_[start].strain.axial * 100, state.strain.axial * 100,
                                 static_cast<std::int64_t>(kRecent - 1 - start),
                                 mean_rate_ > 0 ? fmt::format(", {:.0f} times faster than before",
                                                              burst / mean_rate_)
                                                : ", where nothing had moved before")};
}

}  // namespace triax::lab
