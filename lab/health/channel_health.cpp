// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/channel_health.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace triax::lab {
namespace {

/// So far from what its neighbours lead to expect lies no live reading, in units of the roughness
/// and in steps of the converter.
constexpr double kOutlier = 20;
constexpr double kOutlierSteps = 6;
/// Moves from which roughness and resolution are known well enough.
constexpr std::int64_t kKnown = 16;

}  // namespace

double patience_of(Quantity quantity) {
  const RawChannel& channel = info(quantity).raw;
  return channel.held || channel.counts_water ? 2 : 1;
}

double finest_of(Quantity quantity) {
  const auto unit = sim::find_unit(info(quantity).unit);
  switch (unit ? unit->dimension : sim::Dimension::none) {
    case sim::Dimension::pressure:
      return 1e-3;
    case sim::Dimension::force:
      return 1e-6;
    case sim::Dimension::length:
      return 1e-11;
    case sim::Dimension::volume:
      return 1e-14;
    default:
      return 1e-10;
  }
}

void ChannelHealth::may_rest(bool yes) {
  // What began with a jump is no rest.
  if (may_rest_ != yes && !jump_) noise_.forget_run();
  may_rest_ = yes;
}

void ChannelHealth::add(std::int64_t number, double value) {
  spike_.reset();
  if (std::isnan(value)) {
    miss(number);
    return;
  }
  if (gap_ > 0) {
    if (dead_ && dead_->fault == SensorFault::missing) {
      dead_.reset();
      filled_ = 0;  // a spike is not looked for across the gap
    }
    gap_ = 0;
    steady_ = 0;
  }
  ++steady_;
  if (!dead_) follow_jump(number, value);
  std::shift_left(window_.begin(), window_.end(), 1);
  window_.back() = {number, value};
  filled_ = std::min(filled_ + 1, kWindow);
  follow_run(number, value);
  if (!dead_) look_for_spike();
  last_ = value;
}

void ChannelHealth::miss(std::int64_t number) {
  if (gap_++ == 0) gap_from_ = number;
  if (dead_ || gap_ <= kGap || steady_ < kSteady) return;
  // What stood still since a jump was dead by then.
  dead_ = Dead{SensorFault::missing, jump_ ? jump_begin_ : last_leap().value_or(gap_from_)};
  leap_.reset();
}

/// A leap of which nobody will learn whether it was a spike: the channel died of it.
std::optional<std::int64_t> ChannelHealth::last_leap() const {
  const bool last = leap_ && window_.back().number - *leap_ < kWidest;
  return last ? leap_ : std::nullopt;
}

void ChannelHealth::follow_jump(std::int64_t number, double value) {
  if (leap_ && number - *leap_ > kWidest + 1) leap_.reset();
  if (filled_ < 2 || noise_.moves() < kKnown) return;
  const double before = window_.back().value;
  const double slope = before - window_[kWindow - 2].value;
  const double allowed =
      std::max(kOutlier * noise_.roughness(), kOutlierSteps * noise_.resolution());
  const double off = std::fabs(value - before);
  if (off > allowed && std::fabs(value - before - slope) > allowed) {
    if (!leap_) leap_ = number;
    jump_ = number;
    jump_begin_ = number - *leap_ <= kWidest ? *leap_ : number;
    jump_height_ = off;
  } else if (value != before) {
    jump_.reset();
  }
}

void ChannelHealth::follow_run(std::int64_t number, double value) {
  if (dead_) {
    const bool moved = value != last_;
    if (!revived(moved)) return;
    dead_.reset();
    filled_ = 1;
    return;
  }
  noise_.add(value);
  if (noise_.run() == 0) return;
  if (noise_.run() == 1) run_from_ = number;
  if (may_rest_) return;
  const auto limit = noise_.impossible_run();
  if (!limit) return;
  const auto wait =
      static_cast<std::int64_t>(static_cast<double>(jump_ ? kFlat : *limit) * patience_);
  if (noise_.run() >= wait) condemn();
}

bool ChannelHealth::revived(bool moved) {
  if (moved) ++moves_;
  return moves_ >= kRecovery;
}

void ChannelHealth::condemn() {
  const bool outside = jump_ && (last_ >= noise_.highest() || last_ <= noise_.lowest());
  dead_ =
      Dead{outside ? SensorFault::saturated : SensorFault::stuck, jump_ ? jump_begin_ : run_from_};
  noise_.forget_run();
  jump_.reset();
  leap_.reset();
  moves_ = 0;
}

bool ChannelHealth::is_spike(int width) const {
  const int length = width + 4;
  if (filled_ < length) return false;
  const auto* w = &window_[static_cast<std::size_t>(kWindow - length)];
  const auto at = [&](int i) { return w[i].value; };
  // The level: a line through the middles of the two values before and the two after.
  const double low = (at(0) + at(1)) / 2, high = (at(length - 2) + at(length - 1)) / 2;
  const double slope = (high - low) / (length - 2);
  const auto off = [&](int i) { return at(i) - (low + slope * (i - 0.5)); };
  double scatter = 0;
  for (int i : {0, 1, length - 2, length - 1}) scatter = std::max(scatter, std::fabs(off(i)));
  // Between the first and the last there may be a sound one: then they are two spikes.
  const double least = std::min(std::fabs(off(2)), std::fabs(off(1 + width)));
  // Neither side may run: what changes by itself that fast needs no fault.
  scatter = std::max(scatter, std::fabs(high - low) / 2);
  return least > 5 * scatter && least > kOutlier * noise_.roughness() &&
         least > kOutlierSteps * noise_.resolution();
}

void ChannelHealth::look_for_spike() {
  if (!leap_ || noise_.moves() < kKnown) return;
  for (int width = 1; width <= kWidest; ++width) {
    if (!is_spike(width)) continue;
    const auto first = static_cast<std::size_t>(kWindow - width - 2);
    spike_ =
        Spike{window_[first].number, window_[first + static_cast<std::size_t>(width) - 1].number,
              window_[first].value};
    leap_.reset();
    jump_.reset();
    return;
  }
}

std::int64_t ChannelHealth::first_doubt() const {
  std::int64_t first = kNever;
  if (dead_) return first;
  if (gap_ > 0 && steady_ >= kSteady) first = std::min(first, gap_from_);
  if (leap_) first = std::min(first, *leap_);
  if (jump_ && noise_.run() < kFlat) first = std::min(first, jump_begin_);
  if (!may_rest_ && noise_.run() > 0 && noise_.impossible_run())
    first = std::min(first, jump_ ? jump_begin_ : run_from_);
  return first;
}

}  // namespace triax::lab
