// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/spread_times.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace triax::lab {

bool SpreadTimes::next(Row& row) {
  if (returned_ == group_.size()) read_group();
  if (group_.empty()) {
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    return false;
  }
  row = group_[returned_++];
  return true;
}

std::optional<Row> SpreadTimes::read() {
  if (failure_) return std::nullopt;
  Row row;
  try {
    if (source_(row)) return row;
  } catch (...) {
    failure_ = std::current_exception();
  }
  return std::nullopt;
}

bool SpreadTimes::is_repeated(Row& row) {
  Row& first = group_.front();
  const bool same_stage =
      row.stage == first.stage || (std::isnan(row.stage) && std::isnan(first.stage));
  return same_stage && time_of(row) == time_of(first);
}

void SpreadTimes::read_group() {
  group_.clear();
  returned_ = 0;
  auto row = following_ ? std::exchange(following_, std::nullopt) : read();
  if (!row) return;
  group_.push_back(*row);
  while ((row = read()) && is_repeated(*row) && group_.size() < kMaxRows) group_.push_back(*row);
  following_ = row;
  if (!row || group_.size() == 1) return;
  const bool same_stage = row->stage == group_.front().stage || std::isnan(row->stage);
  if (same_stage && time_of(*row) > time_of(group_.front())) spread(time_of(*row));
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
