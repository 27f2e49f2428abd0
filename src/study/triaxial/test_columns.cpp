// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/test_columns.hpp"

#include <algorithm>
#include <cmath>

#include "lab/measured/unread_steps.hpp"
#include "src/study/triaxial/line_breaks.hpp"

namespace triax::study {
namespace {

/// Columns of what is read on the channel or reduced from it.
std::vector<std::size_t> columns_of(lab::Quantity channel, const lab::RecordHeader& header) {
  lab::Reading reading;
  reading.si.fill(1);
  lab::State state;
  state.strain = {1, 1};
  state.time_s = state.volumetric_strain = state.q = state.p_eff = state.pore_pressure = 1;
  lab::remove_channel(channel, header, reading, state);
  std::vector<double> row;
  db::fill_row(reading, state, row);
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < row.size(); ++i)
    if (std::isnan(row[i])) columns.push_back(i);
  return columns;
}

/// Places of the columns by which unread steps are found.
struct StepColumns {
  std::size_t time = *db::find_read_column("time_s");
  std::size_t axial = *db::find_read_column("axial_strain");
  std::size_t q = *db::find_read_column("q_kPa");
};

/// Adds to columns with q the others by which unread steps are found.
std::vector<std::size_t> with_step_columns(std::span<const std::size_t> columns) {
  std::vector<std::size_t> all(columns.begin(), columns.end());
  const StepColumns steps;
  if (std::ranges::find(all, steps.q) == all.end()) return all;
  for (const std::size_t column : {steps.time, steps.axial})
    if (std::ranges::find(all, column) == all.end()) all.push_back(column);
  return all;
}

}  // namespace

void TestColumns::read(const db::Store& store, std::span<const std::size_t> columns, bool grows) {
  const std::size_t had = readings_.size();
  if (grows && !readings_.empty()) read_new(store);
  std::vector<std::size_t> missing;
  for (const std::size_t column : with_step_columns(columns))
    if (!columns_[column] || readings_.empty()) missing.push_back(column);
  if (!missing.empty()) read_whole(store, missing);
  if (missing.empty() && readings_.size() == had) return;
  find_faults(store);
  remove_faulty();
  find_unread_steps();
}

void TestColumns::find_faults(const db::Store& store) {
  const db::StoredTest test = store.load(test_);
  if (!has_sensor_faults(test)) return;
  if (!health_) health_.emplace(header_with_vouched(test));
  store.for_each_scan_from(test_, next_of_health_,
                           [&](const lab::Reading& reading, const lab::State&) {
                             health_->add(reading);
                             next_of_health_ = reading.number + 1;
                           });
  faults_.clear();
  for (const lab::FaultySpan& span : health_->spans())
    faults_.push_back({span, columns_of(span.channel, test.header)});
}

void TestColumns::remove_faulty() {
  for (const auto& [span, columns] : faults_) {
    const auto from = std::ranges::lower_bound(readings_, span.from) - readings_.begin();
    const auto end = std::ranges::upper_bound(readings_, span.until) - readings_.begin();
    for (const std::size_t column : columns)
      if (columns_[column])
        std::fill(columns_[column]->begin() + from, columns_[column]->begin() + end, lab::kMissing);
  }
}

void TestColumns::find_unread_steps() {
  unread_steps_.clear();
  const StepColumns columns;
  if (!columns_[columns.q]) return;
  lab::UnreadSteps steps(true);
  for (std::size_t i = 0; i < readings_.size(); ++i) {
    lab::State state;
    state.reading = readings_[i];
    state.time_s = (*columns_[columns.time])[i];
    state.strain.axial = (*columns_[columns.axial])[i];
    state.q = (*columns_[columns.q])[i] * 1e3;
    if (steps.add(state)) unread_steps_.push_back(state.reading);
  }
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
  const auto read = with_step_columns(columns);
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (columns_[i] || std::ranges::find(read, i) != read.end()) ++held;
  const std::size_t points = work || has_work_ ? scans : 0;  // of a scan there is one at most
  return held * scans * sizeof(double) + points * sizeof(lab::SecondOrderWorkPoint);
}

}  // namespace triax::study
