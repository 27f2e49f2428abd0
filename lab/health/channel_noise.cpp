// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/channel_noise.hpp"

#include <algorithm>
#include <cmath>

#include "lab/health/sensor_limits.hpp"

namespace triax::lab {
namespace {

namespace limits = sensor_limits;

/// Below this share of the channel's largest value a difference is round-off, not a reading.
constexpr double kRoundOff = 1e-9;
/// The most neighbours of one run that are learned from.
constexpr std::int64_t kLongestLesson = 1024;
/// In steps of the converter, and the share of such moves from which noise is no flicker: white
/// noise of half a step rms, that at rest in the middle of a step leaves it every third time.
constexpr double kWide = 1.5, kLeastWide = 0.08;
const double kImpossible = std::log(limits::kChance);

/// Of the latest of `count` in an exponential mean that begins as a plain one.
double weight_of(std::int64_t count) {
  if (count >= ChannelNoise::kMemory) return 1.0 / ChannelNoise::kMemory;
  return 1.0 / static_cast<double>(count);
}

}  // namespace

void ChannelNoise::add(double value) {
  if (values_ == 0) {
    lowest_ = highest_ = value;
  } else if (std::fabs(value - last_) <= round_off()) {
    ++run_;
  } else {
    end_run();
    const double move = value - last_;
    const double size = std::fabs(move);
    step_ = step_ > 0 ? std::min(step_, size) : size;
    if (moves_++ > 0) {
      const double weight = weight_of(moves_);
      moves_back_ += weight * ((move * last_move_ < 0 ? 1.0 : 0.0) - moves_back_);
      wide_moves_ += weight * ((size > kWide * step_ ? 1.0 : 0.0) - wide_moves_);
    }
    last_move_ = move;
  }
  if (values_ >= 2 && run_ == 0) add_roughness(last_ - (before_ + value) / 2);
  lowest_ = std::min(lowest_, value);
  highest_ = std::max(highest_, value);
  largest_ = std::max(largest_, std::fabs(value));
  before_ = values_ == 0 ? value : last_;
  last_ = value;
  ++values_;
}

double ChannelNoise::round_off() const { return std::max(finest_, kRoundOff * largest_); }

double ChannelNoise::resolution() const { return std::max(step_, round_off()); }

void ChannelNoise::end_run() {
  const std::int64_t looked = neighbours_ / kLessons;
  const std::int64_t lessons = std::min(run_, kLongestLesson);
  for (std::int64_t i = 0; i <= lessons; ++i) {
    ++neighbours_;
    const double weight = weight_of(neighbours_);
    equal_ += weight * ((i < lessons ? 1.0 : 0.0) - equal_);
    longest_run_ *= 1 - 1.0 / (8 * kMemory);
  }
  longest_run_ = std::max(longest_run_, static_cast<double>(run_));
  run_ = 0;
  if (neighbours_ / kLessons != looked) wait_ = wait();
}

void ChannelNoise::add_roughness(double half_bend) {
  ++bends_;
  double size = std::fabs(half_bend);
  // A smooth curve shows its resolution here, not in its moves.
  if (2 * size > round_off()) step_ = step_ > 0 ? std::min(step_, 2 * size) : 2 * size;
  if (bends_ > 32) size = std::min(size, 5 * roughness_ + step_);
  const double weight = weight_of(bends_);
  roughness_ += weight * (size - roughness_);
  bends_back_ += weight * ((half_bend * last_bend_ < 0 ? 1.0 : 0.0) - bends_back_);
  last_bend_ = half_bend;
}

double ChannelNoise::equal_share_at_most() const {
  const double n = static_cast<double>(std::min<std::int64_t>(neighbours_, kMemory));
  return equal_ + 3 * std::sqrt((equal_ * (1 - equal_) + 1 / n) / n);
}

bool ChannelNoise::dithers() const {
  if (neighbours_ < kLeast || equal_share_at_most() > 0.7) return false;
  const bool turns_back = moves_back_ >= 0.4 && wide_moves_ >= kLeastWide;
  const bool rough = roughness_ > std::max(1.1 * step_, 10 * round_off()) && bends_back_ >= 0.5;
  return turns_back || rough;
}

std::optional<std::int64_t> ChannelNoise::wait() const {
  if (!dithers()) return std::nullopt;
  const double wait = std::max({limits::kStuck.value, kImpossible / std::log(equal_share_at_most()),
                                limits::kLongerRun * longest_run_});
  if (wait > limits::kMaxRun) return std::nullopt;
  return std::llround(std::ceil(wait));
}

}  // namespace triax::lab
