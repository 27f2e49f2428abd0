// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/spread_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace triax::lab {

Row* SpreadTimes::next() {
  if (returned_ < group_.size()) return &group_[returned_++];
  if (!std::exchange(has_begun_, true)) read_following();
  if (!has_following_) {
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    return nullptr;
  }
  std::swap(current_, following_);
  read_following();
  if (!has_following_ || !is_repeated(*current_)) {
    end_time(*current_, 1);
    return current_;
  }
  read_group(*current_);
  end_time(group_.front(), group_.size());
  return &group_[returned_++];
}

void SpreadTimes::read_following() {
  has_following_ = false;
  try {
    has_following_ = source_(*following_);
  } catch (...) {
    failure_ = std::current_exception();
  }
}

bool SpreadTimes::is_repeated(Row& first) {
  return time_of(*following_) == time_of(first) &&
         (following_->stage == first.stage ||
          (std::isnan(following_->stage) && std::isnan(first.stage)));
}

/// Pre-condition: `first` is repeated.
void SpreadTimes::read_group(const Row& first) {
  group_ = {first};
  returned_ = 0;
  do {
    group_.push_back(*following_);
    read_following();
  } while (has_following_ && group_.size() < kMaxRows && is_repeated(group_.front()));
}

/// All `count` rows of a time are known, and the row after them.
void SpreadTimes::end_time(Row& first, std::size_t count) {
  const double time = time_of(first);
  const bool same_stage =
      has_following_ && (following_->stage == first.stage || std::isnan(following_->stage));
  if (same_stage && time_of(*following_) > time) {
    step_s_ = time_of(*following_) - time;
    before_ = count;
    if (count > 1) spread(time_of(*following_));
  } else if (!same_stage) {
    if (count > 1 && before_ > 1) {
      // As far apart as the rows of the time before.
      const double share = static_cast<double>(count) / static_cast<double>(before_);
      spread(time + step_s_ * std::min(1.0, share));
    }
    before_ = 0;
  }
}

void SpreadTimes::spread(double next_time_s) {
  const double time = time_of(group_.front());
  const auto count = static_cast<double>(group_.size());
  findings_.note("time repeated", group_[1].line, [&] {
    return fmt::format(
        "the time {:g} s appears {} times: these rows are spread evenly up to {:g} s", time,
        group_.size(), next_time_s);
  });
  for (std::size_t i = 1; i < group_.size(); ++i)
    time_of(group_[i]) = time + (next_time_s - time) * static_cast<double>(i) / count;
}

}  // namespace triax::lab
