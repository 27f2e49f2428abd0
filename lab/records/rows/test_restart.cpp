// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/test_restart.hpp"

#include <cmath>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>

namespace triax::lab {
namespace {

using enum Quantity;

/// The value of the first column of these that has one; `column` keeps which it was.
double first_of(std::initializer_list<Quantity> columns, std::optional<Quantity>& column,
                const Row& row) {
  if (!column)
    for (const Quantity quantity : columns)
      if (!column && !std::isnan(row.si[index(quantity)])) column = quantity;
  return column ? row.si[index(*column)] : kMissing;
}

/// The load that shears the specimen: q by the first columns that give it, else the axial force.
double load_of(const Row& row) {
  const auto at = [&](Quantity quantity) { return row.si[index(quantity)]; };
  double load = at(deviator_stress);
  if (std::isnan(load)) load = at(effective_axial_stress) - at(effective_radial_stress);
  if (std::isnan(load)) load = at(axial_stress) - at(radial_stress);
  if (std::isnan(load)) load = at(stress_ratio) * at(mean_effective_stress);
  return std::isnan(load) ? at(axial_force) : load;
}

}  // namespace

RowState TestRestart::state_of(const Row& row) {
  RowState now{};
  now[index(RowValue::strain)] =
      first_of({axial_strain, axial_displacement, shear_strain}, strain_, row);
  now[index(RowValue::load)] = load_of(row);
  now[index(RowValue::pressure)] = first_of(
      {mean_effective_stress, effective_radial_stress, excess_pore_pressure, pore_pressure},
      pressure_, row);
  now[index(RowValue::cycle)] = row.si[index(cycle)];
  now[index(RowValue::time)] = std::isnan(row.time_s) ? row.stage_time_s : row.time_s;
  return now;
}

bool TestRestart::begins_new_stage(const Row& row) {
  if (std::isnan(row.stage)) return false;
  const bool is_first = stages_.empty();
  return stages_.insert(row.stage).second && !is_first;
}

std::optional<Restart> TestRestart::find(const Row& row) {
  const RowState now = state_of(row);
  const std::int64_t line_before = std::exchange(last_line_, row.line), reading = readings_++;
  if (!std::isnan(row.test)) {
    const double before = std::exchange(test_, row.test);
    if (std::isnan(before) || before == row.test) return std::nullopt;
    Restart other;
    other.first = now;
    other.line_before = line_before;
    other.line = row.line;
    other.reading = reading;
    return other;
  }
  const auto found = finder_.add(now, row.line, begins_new_stage(row));
  if (found) stages_.clear();
  if (found && !std::isnan(row.stage)) stages_.insert(row.stage);
  return found;
}

void TestRestart::add(const Row& row) {
  if (const auto restart = find(row))
    throw SeveralTests(file_, restart->line,
                       describe(*restart) +
                           "; triax replay FILE reads each test of a file; if it is one test, add "
                           "a column with stage numbers");
}

std::string TestRestart::describe(const Restart& restart) const {
  std::string text = fmt::format("a second test begins with reading {}: ", restart.reading);
  if (!std::isnan(test_)) return text + "the column that names the tests changes";
  const QuantityInfo& row = info(*strain_);
  const double scale = row.unit.empty() ? 1 : sim::find_unit(row.unit)->scale;
  const auto strain = index(RowValue::strain), time = index(RowValue::time);
  text += fmt::format("between line {} and line {} {} decreases from {:.4g} to {:.4g}",
                      restart.line_before, restart.line, heading(*strain_),
                      restart.before[strain] / scale, restart.first[strain] / scale);
  if (restart.is_time_back())
    return text +
           fmt::format(", and time_s from {:g} to {:g}", restart.before[time], restart.first[time]);
  return text + ", and the load to its first value";
}

void TestRestart::finish(Findings& findings) const {
  if (const auto open = finder_.open())
    findings.note("restart", open->line,
                  "it seems that " + describe(*open) + "; the file ends before that is certain");
}

}  // namespace triax::lab
