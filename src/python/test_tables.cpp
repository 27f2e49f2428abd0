// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/python/test_tables.hpp"

#include <array>

#include "src/python/signals.hpp"
#include "src/study/handover/state_columns.hpp"

namespace triax::python {
namespace {

/// Columns of a table while it is filled.
template <class Number>
using Filled = std::vector<std::vector<Number>*>;

/// `reading` and `stage` first.
struct Table {
  explicit Table(std::size_t doubles) { columns.columns.reserve(doubles + 2); }
  template <class Number = double>
  std::vector<Number>& add(const std::string& name, std::int64_t rows) {
    auto& values = columns.add<Number>(name);
    values.reserve(static_cast<std::size_t>(rows));
    return values;
  }
  Columns columns;
};

}  // namespace

Columns table_of_states(const db::Store& store, std::int64_t id) {
  const std::int64_t rows = store.scan_count(id);
  const auto& held = study::state_columns();
  Table table(held.size());
  auto& reading = table.add<std::int64_t>("reading", rows);
  auto& stage = table.add<std::int64_t>("stage", rows);
  Filled<double> filled;
  std::vector<double (*)(const lab::State&)> values;
  for (const auto& column : held) {
    if (column.name == "reading" || column.name == "stage") continue;  // whole numbers, above
    filled.push_back(&table.add(column.name, rows));
    values.push_back(column.value);
  }
  Signals signals;
  store.for_each_scan(id, 1, [&](const lab::Reading&, const lab::State& state) {
    signals.look();
    reading.push_back(state.reading);
    stage.push_back(state.stage);
    for (std::size_t i = 0; i < filled.size(); ++i) filled[i]->push_back(values[i](state));
  });
  return std::move(table.columns);
}

Columns table_of_readings(const db::Store& store, const db::StoredTest& test) {
  const std::int64_t rows = store.scan_count(test.id);
  const auto& held = test.header.columns;
  Table table(held.size() + 1);
  auto& reading = table.add<std::int64_t>("reading", rows);
  auto& stage = table.add<std::int64_t>("stage", rows);
  auto& time = table.add("time_s", rows);
  Filled<double> filled;
  std::vector<double> units;
  for (const lab::Quantity quantity : held) {
    filled.push_back(&table.add(lab::heading(quantity), rows));
    const auto unit = lab::info(quantity).unit;
    units.push_back(unit.empty() ? 1 : sim::find_unit(unit)->scale);
  }
  Signals signals;
  store.for_each_scan(test.id, 1, [&](const lab::Reading& r, const lab::State&) {
    signals.look();
    reading.push_back(r.number);
    stage.push_back(r.stage);
    time.push_back(r.time_s);
    for (std::size_t i = 0; i < held.size(); ++i) filled[i]->push_back(r[held[i]] / units[i]);
  });
  return std::move(table.columns);
}

Columns table_of_work(const db::Store& store, std::int64_t id) {
  const auto points = store.second_order_work(id);
  const auto rows = static_cast<std::int64_t>(points.size());
  Table table(8);
  auto& reading = table.add<std::int64_t>("reading", rows);
  auto& window = table.add<std::int64_t>("window_readings", rows);
  const Filled<double> filled = {
      &table.add("time_s", rows),          &table.add("axial_strain_path", rows),
      &table.add("small_strain", rows),    &table.add("eulerian", rows),
      &table.add("semi_lagrangian", rows), &table.add("normalised", rows),
      &table.add("normalised_error", rows)};
  Signals signals;
  for (const lab::SecondOrderWorkPoint& point : points) {
    signals.look();
    reading.push_back(point.reading);
    window.push_back(point.window_readings);
    const sim::SecondOrderWork& w = point.work;
    const std::array values = {
        point.time_s, point.axial_strain_path, w.small_strain, w.eulerian, w.semi_lagrangian,
        w.normalised, point.normalised_error};
    for (std::size_t i = 0; i < values.size(); ++i) filled[i]->push_back(values[i]);
  }
  return std::move(table.columns);
}

}  // namespace triax::python
