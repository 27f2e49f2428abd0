// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/channel_health.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/health/sensor_limits.hpp"

namespace triax::lab {
namespace {

namespace limits = sensor_limits;

/// Moves from which roughness and resolution are known well enough.
constexpr std::int64_t kKnown = 16;

double weak_of(double value, std::int64_t width) {
  return value == 0 && width > 1 ? limits::kZeroSpike : limits::kWeakSpike;
}

}  // namespace

double patience_of(Quantity quantity) {
  const RawChannel& channel = info(quantity).raw;
  return channel.held || channel.counts_water ? limits::kPatience : 1.0;
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

double worth_of(Quantity quantity) {
  if (const double drift = info(quantity).raw.drift_si; drift > 0) return drift;
  const auto unit = sim::find_unit(info(quantity).unit);
  return unit && unit->dimension == sim::Dimension::pressure ? limits::kEarlyPressure
                                                             : limits::kEarlyStrain;
}

void ChannelHealth::may_rest(bool yes) {
  // What began with a jump is no rest.
  if (may_rest_ != yes && !jump_) noise_.forget_run();
  may_rest_ = yes;
}

void ChannelHealth::add(std::int64_t number, double value) {
  spike_.reset();
  leaps_ <<= 1U;
  latest_ = number;
  if (std::isnan(value)) {
    miss(number);
    return;
  }
  if (gap_ > 0) {
    if (dead_ && dead_->fault == SensorFault::missing) {
      dead_.reset();
      filled_ = 0;  // a spike is not looked for across the gap
      forget_leap();
    }
    gap_ = 0;
    steady_ = 0;
  }
  ++steady_;
  if (noise_.values() == 0) {
    start_ = {number, value};
    starts_ = value != 0;
  }
  if (!dead_) follow_jump(number, value);
  std::shift_left(window_.begin(), window_.end(), 1);
  window_.back() = {number, value};
  filled_ = std::min(filled_ + 1, kWindow);
  follow_run(number, value);
  if (!dead_ && (starts_ || leap_)) look_for_spike();
  last_ = value;
}

void ChannelHealth::miss(std::int64_t number) {
  if (gap_++ == 0) gap_from_ = number;
  if (dead_ || gap_ <= limits::kMissing.count() || steady_ < limits::kRegular.count()) return;
  // What stood still since a jump was dead by then.
  dead_ = Dead{SensorFault::missing, jump_ ? jump_begin_ : last_leap().value_or(gap_from_)};
  forget_leap();
}

/// A leap of which nobody will learn whether it was a spike: the channel died of it.
std::optional<std::int64_t> ChannelHealth::last_leap() const {
  const bool last = leap_ && window_.back().number - *leap_ < limits::kSpike.count();
  return last ? leap_ : std::nullopt;
}

/// Before the reading `number` is taken: one value since the leap, zero or at the end of a range.
bool ChannelHealth::is_flat_since_leap(std::int64_t number) const {
  const std::int64_t width = number - *leap_;
  return noise_.run() >= width - 1 &&
         width <= (last_ == 0 ? limits::kZeroDropout.count() : limits::kDropout.count());
}

void ChannelHealth::forget_leap() {
  leap_.reset();
  back_.reset();
}

void ChannelHealth::follow_jump(std::int64_t number, double value) {
  if (leap_ && number - *leap_ > limits::kSpike.count() && !back_) {
    if (is_flat_since_leap(number) && value != last_)
      back_ = number;
    else if (number - *leap_ > limits::kSpike.count() + 1 && !is_flat_since_leap(number))
      leap_.reset();
  }
  if (filled_ == 0) return;
  const bool known = noise_.moves() >= kKnown;
  const double before = window_.back().value;
  const double slope = filled_ > 1 ? before - window_[kWindow - 2].value : 0;
  double allowed =
      std::max(limits::kJump * noise_.roughness(), limits::kJumpSteps * noise_.resolution());
  if (!known)
    allowed = std::max({allowed, limits::kEarlyJump * std::fabs(slope),
                        limits::kEarlyLevel * std::fabs(before), worth_});
  const double off = std::fabs(value - before);
  // The first move of a channel is a leap if the next one is far smaller.
  if (filled_ == 2 && std::fabs(slope) > limits::kFirstChange * off) leaps_ |= 2U;
  if (off > allowed && std::fabs(value - before - slope) > allowed) {
    if (filled_ > 1) leaps_ |= 1U;
    // The first move of a channel at rest may be one; a far larger one takes its place.
    const bool was_first = leap_ && !certain_ && before1_ == before2_;
    if (!leap_ || (was_first && off > 2 * leap_height_)) begin_leap(number, off, allowed, known);
    if (!known) return;
    jump_ = number;
    jump_begin_ = number - *leap_ <= limits::kSpike.count() ? *leap_ : number;
    jump_height_ = off;
  } else if (value != before) {
    jump_.reset();
  }
}

/// Before the value of the reading `number` is taken.
void ChannelHealth::begin_leap(std::int64_t number, double height, double allowed, bool known) {
  back_.reset();
  leap_ = number;
  leap_height_ = height;
  allowed_ = allowed;
  certain_ = known;
  before1_ = window_.back().value;
  before2_ = filled_ > 1 ? window_[kWindow - 2].value : before1_;
  lowest_ = noise_.lowest();
  highest_ = noise_.highest();
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
  if (may_be_at_rest()) return;
  const auto limit = noise_.impossible_run();
  if (!limit) return;
  const auto wait = static_cast<std::int64_t>(
      static_cast<double>(jump_ ? limits::kStuckAfterJump.count() : *limit) * patience_);
  if (noise_.run() >= wait) condemn();
}

bool ChannelHealth::revived(bool moved) {
  if (moved) ++moves_;
  return moves_ >= limits::kRecovery.count();
}

void ChannelHealth::condemn() {
  const bool outside = jump_ && (last_ >= noise_.highest() || last_ <= noise_.lowest());
  dead_ =
      Dead{outside ? SensorFault::saturated : SensorFault::stuck, jump_ ? jump_begin_ : run_from_};
  noise_.forget_run();
  jump_.reset();
  forget_leap();
  moves_ = 0;
}

double ChannelHealth::leaves(const Level& level, int width, double first, double last) const {
  // A line through the middles of the two values before and the two after.
  const double low = (level.before2 + level.before1) / 2;
  const double high = (level.after1 + level.after2) / 2;
  const double slope = (high - low) / (width + 2);
  const auto off = [&](double value, int i) {
    return std::fabs(value - (low + slope * (i - 0.5)));
  };
  // Neither side may run: what changes by itself that fast needs no fault.
  const double scatter =
      std::max({off(level.before2, 0), off(level.before1, 1), off(level.after1, width + 2),
                off(level.after2, width + 3), std::fabs(high - low) / 2});
  // Between the first and the last there may be a sound one: then they are two spikes.
  const double least = std::min(off(first, 2), off(last, width + 1));
  return least > allowed_ ? least / scatter : 0;
}

void ChannelHealth::look_for_spike() {
  if (starts_) look_for_start();
  if (!leap_) return;
  if (back_) {
    look_for_flat();
    return;
  }
  for (int width = 1; width <= limits::kSpike.count(); ++width) {
    const int begin = kWindow - width - 2;
    const Value& first = window_[static_cast<std::size_t>(begin)];
    // Weakly only where the leap began: any later pair of neighbours is a part of what leaped.
    const bool began = first.number == *leap_;
    if (filled_ < width + (began ? 3 : 4)) return;
    const auto at = [&](int i) { return window_[static_cast<std::size_t>(i)].value; };
    const Level level{began ? before2_ : at(begin - 2), began ? before1_ : at(begin - 1),
                      at(kWindow - 2), at(kWindow - 1)};
    const double clear = leaves(level, width, first.value, at(kWindow - 3));
    const bool weakly = began && (!certain_ || first.value == 0) && level.after1 != first.value;
    if (!(clear > (weakly ? weak_of(first.value, width) : limits::kClearSpike))) continue;
    spike_ = Spike{first.number, window_[kWindow - 3].number, first.value,
                   certain_ && clear > limits::kClearSpike, first.number};
    forget_leap();
    jump_.reset();
    return;
  }
}

/// A longer run of one value, which ended at the reading before this one.
void ChannelHealth::look_for_flat() {
  if (latest_ == *back_) return;
  const auto width = static_cast<int>(*back_ - *leap_);
  const Level level{before2_, before1_, window_[kWindow - 2].value, window_.back().value};
  const double value = window_[kWindow - 3].value;
  if (leaves(level, width, value, value) > weak_of(value, width))
    spike_ = Spike{*leap_, *back_ - 1, value, false, *leap_};
  forget_leap();
}

/// The record begins with one value, far beyond all to which the channel leaps from it.
void ChannelHealth::look_for_start() {
  if (noise_.moves() == 0) {
    start_until_ = latest_;
    starts_ = latest_ - start_.number < limits::kDropout.count();
    return;
  }
  const double value = window_.back().value;
  if (after_start_ < 3) next_[static_cast<std::size_t>(after_start_)] = value;
  low_after_ = after_start_ == 0 ? value : std::min(low_after_, value);
  high_after_ = after_start_ == 0 ? value : std::max(high_after_, value);
  if (++after_start_ < kAfterStart) return;
  starts_ = false;
  const double largest = std::max(std::fabs(low_after_), std::fabs(high_after_));
  const double off = std::max(start_.value - high_after_, low_after_ - start_.value);
  if (!(std::fabs(start_.value) > limits::kFirstValue * largest &&
        off > worth_ + limits::kWeakSpike * (high_after_ - low_after_)))
    return;
  // A curve that is steep where it begins comes near its first value when it is followed back.
  const auto& [first, second, third] = next_;
  const double curve = 3 * first - 3 * second + third;
  const double move = std::max(std::fabs(second - first), std::fabs(third - second));
  if (std::fabs(start_.value - curve) > limits::kFirstChange * move)
    spike_ = Spike{start_.number, start_until_, start_.value, false, start_until_ + 1};
}

void ChannelHealth::finish(std::int64_t last) {
  spike_.reset();
  if (!leap_ || dead_ || latest_ != last) return;
  const Spike to_the_end{*leap_, last, last_, false, *leap_};
  if (!back_ && is_flat_since_leap(last + 1)) {
    const bool beyond = *leap_ < last && (last_ > highest_ || last_ < lowest_);
    if (last_ == 0 || beyond) spike_ = to_the_end;
  } else if (const auto width = static_cast<int>(last - *leap_);
             back_ == last || (!back_ && width <= limits::kSpike.count())) {
    // One value came back, and the record ends.
    const double value = window_[kWindow - 2].value;
    if (leaves({before2_, before1_, last_, last_}, width, value, value) > weak_of(value, width))
      spike_ = Spike{*leap_, last - 1, value, false, *leap_};
  }
  forget_leap();
}

bool ChannelHealth::leaped_at(std::int64_t number) const {
  const std::int64_t ago = latest_ - number;
  return ago >= 0 && ago < 64 && ((leaps_ >> static_cast<unsigned>(ago)) & 1U) != 0;
}

std::int64_t ChannelHealth::first_doubt() const {
  std::int64_t first = kNever;
  if (dead_) return first;
  if (starts_) first = std::min(first, start_.number);
  if (gap_ > 0 && steady_ >= limits::kRegular.count()) first = std::min(first, gap_from_);
  if (leap_) first = std::min(first, *leap_);
  if (jump_ && noise_.run() < limits::kStuckAfterJump.count()) first = std::min(first, jump_begin_);
  if (!may_be_at_rest() && noise_.run() > 0 && noise_.impossible_run())
    first = std::min(first, jump_ ? jump_begin_ : run_from_);
  return first;
}

}  // namespace triax::lab
