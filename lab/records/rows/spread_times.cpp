// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/spread_times.hpp"

#include <fmt/format.h>

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
  if (!has_following_ || !is_repeated(*current_)) return current_;
  read_group(*current_);
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
  if (!has_following_) return;
  const bool same_stage =
      following_->stage == group_.front().stage || std::isnan(following_->stage);
  if (same_stage && time_of(*following_) > time_of(group_.front())) spread(time_of(*following_));
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
