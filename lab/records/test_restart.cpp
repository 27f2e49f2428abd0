// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/test_restart.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"

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

/// What shears the specimen: q by the first columns that give it, else the axial force.
double load_of(const Row& row) {
  const auto at = [&](Quantity quantity) { return row.si[index(quantity)]; };
  double load = at(deviator_stress);
  if (std::isnan(load)) load = at(effective_axial_stress) - at(effective_radial_stress);
  if (std::isnan(load)) load = at(axial_stress) - at(radial_stress);
  if (std::isnan(load)) load = at(stress_ratio) * at(mean_effective_stress);
  return std::isnan(load) ? at(axial_force) : load;
}

}  // namespace

/// A value that is missing or has not moved at all has not returned.
bool TestRestart::Track::is_returned(double now) const {
  return largest > 0 && std::fabs(now - first) <= kReturned_fraction * largest;
}

bool TestRestart::Track::jumps(double now) const {
  return largest_step > 0 && std::fabs(now - last) > kJump_steps * largest_step;
}

void TestRestart::Track::add(double now, bool begins_new_stage) {
  if (std::isnan(now)) return;
  if (std::isnan(first)) first = last = now;
  if (!begins_new_stage) largest_step = std::max(largest_step, std::fabs(now - last));
  largest = std::max(largest, std::fabs(now - first));
  last = now;
}

TestRestart::Values TestRestart::values_of(const Row& row) {
  Values now{};
  now[kStrain] = first_of({axial_strain, axial_displacement, shear_strain}, strain_, row);
  now[kLoad] = load_of(row);
  now[kPressure] = first_of(
      {mean_effective_stress, effective_radial_stress, excess_pore_pressure, pore_pressure},
      pressure_, row);
  now[kCycle] = row.si[index(cycle)];
  now[kTime] = std::isnan(row.time_s) ? row.stage_time_s : row.time_s;
  return now;
}

void TestRestart::add(const Row& row, std::int64_t reading, bool begins_new_stage) {
  const Values now = values_of(row);
  if (std::isnan(now[kStrain])) return;
  if (candidate_) {
    follow(now);
  } else if (!begins_new_stage && is_back_at_start(now)) {
    candidate_ = {.first = now, .line_before = last_line_, .line = row.line, .reading = reading};
    candidate_->last_strain = now[kStrain];
    for (std::size_t i = 0; i < kValueCount; ++i) candidate_->before[i] = tracks_[i].last;
  } else {
    continue_test(now, begins_new_stage);
  }
  last_line_ = row.line;
}

bool TestRestart::is_back_at_start(const Values& now) const {
  const auto is_returned = [&](Value value) { return tracks_[value].is_returned(now[value]); };
  const auto jumps = [&](Value value) { return tracks_[value].jumps(now[value]); };
  if (!is_returned(kStrain)) return false;
  const bool loaded_as_first = is_returned(kLoad);
  if (jumps(kStrain) && (now[kTime] < tracks_[kTime].last || loaded_as_first)) return true;
  if (!loaded_as_first) return false;
  return (now[kTime] < tracks_[kTime].last && is_returned(kTime)) ||
         (is_returned(kPressure) && (jumps(kPressure) || jumps(kLoad) || jumps(kCycle)));
}

void TestRestart::continue_test(const Values& now, bool begins_new_stage) {
  for (std::size_t i = 0; i < kValueCount; ++i) tracks_[i].add(now[i], begins_new_stage);
}

/// A row after the one that may begin a second test.
void TestRestart::follow(const Values& now) {
  constexpr int kRows = 3;
  Candidate& candidate = *candidate_;
  const Track& strain = tracks_[kStrain];
  const bool strain_jumps_back =
      std::fabs(now[kStrain] - candidate.last_strain) > kJump_steps * strain.largest_step &&
      !strain.is_returned(now[kStrain]);
  const bool clock_goes_on = candidate.time_back() && !(now[kTime] < candidate.before[kTime]);
  if (strain_jumps_back || clock_goes_on) {
    candidate_.reset();
    continue_test(now, false);
    return;
  }
  candidate.last_strain = now[kStrain];
  ++candidate.rows;
  const bool moves_on = candidate.time_back()
                            ? now[kTime] > candidate.first[kTime]
                            : candidate.rows >= kRows && !strain.is_returned(now[kStrain]);
  if (moves_on)
    throw BadInput(
        file_, candidate.line,
        describe(candidate) + "; split the file there, or add a column with stage numbers");
}

std::string TestRestart::describe(const Candidate& candidate) const {
  const QuantityInfo& row = info(*strain_);
  const double scale = row.unit.empty() ? 1 : sim::find_unit(row.unit)->scale;
  std::string text = fmt::format(
      "a second test begins with reading {}: between line {} and line {} {} decreases from {:.4g} "
      "to {:.4g}",
      candidate.reading, candidate.line_before, candidate.line, heading(*strain_),
      candidate.before[kStrain] / scale, candidate.first[kStrain] / scale);
  if (candidate.time_back())
    return text + fmt::format(", and time_s from {:g} to {:g}", candidate.before[kTime],
                              candidate.first[kTime]);
  return text + ", and the load to its first value";
}

void TestRestart::finish(Findings& findings) const {
  if (candidate_)
    findings.note(
        "restart", candidate_->line,
        "it seems that " + describe(*candidate_) + "; the file ends before that is certain");
}

}  // namespace triax::lab
