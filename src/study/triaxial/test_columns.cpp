// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/test_columns.hpp"

#include <algorithm>

namespace triax::study {

void TestColumns::read(const db::Store& store, std::span<const std::size_t> columns, bool grows) {
  if (grows && !readings_.empty()) read_new(store);
  std::vector<std::size_t> missing;
  for (const std::size_t column : columns)
    if (!columns_[column] || readings_.empty()) missing.push_back(column);
  if (!missing.empty()) read_whole(store, missing);
}

/// A writer may be at work between two columns: all end with the scan that is the last of the
/// first.
void TestColumns::read_whole(const db::Store& store, const std::vector<std::size_t>& missing) {
  const bool first = readings_.empty();
  std::vector<std::vector<double>> read(missing.size());
  const std::size_t count =
      first ? static_cast<std::size_t>(store.scan_count(test_)) : readings_.size();
  std::vector<std::int64_t> readings;
  if (first) readings.reserve(count);
  for (auto& column : read) column.reserve(count);
  store.for_each_row(test_, 0, missing, [&](std::int64_t reading, std::span<const double> values) {
    if (first)
      readings.push_back(reading);
    else if (read.front().size() == readings_.size())
      return;
    for (std::size_t i = 0; i < values.size(); ++i) read[i].push_back(values[i]);
  });
  // Only now, when nothing can fail any more: numbers without their columns would stand for all.
  if (first) readings_ = std::move(readings);
  for (std::size_t i = 0; i < missing.size(); ++i) columns_[missing[i]] = std::move(read[i]);
}

void TestColumns::read_new(const db::Store& store) {
  std::vector<std::size_t> present;
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (columns_[i]) present.push_back(i);
  store.for_each_row(test_, readings_.back() + 1, present,
                     [&](std::int64_t reading, std::span<const double> values) {
                       readings_.push_back(reading);
                       for (std::size_t i = 0; i < values.size(); ++i)
                         columns_[present[i]]->push_back(values[i]);
                     });
}

void TestColumns::read_work(const db::Store& store, bool grows) {
  if (has_work_ && !grows) return;
  work_ = store.second_order_work(test_);
  has_work_ = true;
}

std::size_t TestColumns::bytes_with(std::span<const std::size_t> columns, bool work,
                                    std::size_t scans) const {
  std::size_t held = 1;  // numbers of readings
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (columns_[i] || std::ranges::find(columns, i) != columns.end()) ++held;
  const std::size_t points = work || has_work_ ? scans : 0;  // of a scan there is one at most
  return held * scans * sizeof(double) + points * sizeof(lab::SecondOrderWorkPoint);
}

}  // namespace triax::study
