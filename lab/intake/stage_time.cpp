// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/stage_time.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace triax::lab {
namespace {

/// The rows in which a column of numbers or words changes.
std::vector<bool> changes_of(const TableColumn& column) {
  std::vector<bool> out(column.all.size());
  std::size_t before = 0;
  for (std::size_t row = 1; row < out.size(); ++row) {
    if (!column.texts.empty()) {
      if (column.texts[row].empty()) continue;
      out[row] = column.texts[row] != column.texts[before];
    } else {
      if (std::isnan(column.all[row])) continue;
      out[row] = !std::isnan(column.all[before]) && column.all[row] != column.all[before];
    }
    before = row;
  }
  return out;
}

bool falls_back(const std::vector<double>& times, const std::vector<bool>& stage_begins) {
  std::size_t falls = 0;
  double before = NAN;
  for (std::size_t row = 0; row < times.size(); ++row) {
    if (stage_begins[row] && !(times[row] < before)) return false;
    if (!stage_begins[row] && times[row] < before) return false;
    falls += stage_begins[row] ? 1 : 0;
    if (!std::isnan(times[row])) before = times[row];
  }
  return falls > 0;
}

}  // namespace

std::optional<std::size_t> find_stage_time(const TableColumns& table, const Meaning& meaning) {
  const ColumnMeaning* stage = meaning.of("stage");
  if (stage == nullptr || meaning.of("stage_time") != nullptr) return std::nullopt;
  const auto begins =
      changes_of(table.columns[static_cast<std::size_t>(stage - meaning.columns.data())]);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const LexiconQuantity* quantity = meaning.columns[i].reading.quantity;
    const TableColumn& column = table.columns[i];
    if (!quantity || quantity->name != "time") continue;
    if (falls_back(column.clock ? column.clock_values : column.all, begins)) return i;
  }
  return std::nullopt;
}

ColumnSample stage_time_sample(ColumnSample sample, const ColumnReading& reading) {
  sample.headings = {"Stage time"};
  sample.unit_of_row = reading.unit_source == UnitSource::identity ? "" : reading.unit;
  return sample;
}

}  // namespace triax::lab
