// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/shear_series.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <utility>

#include "src/study/triaxial/collapse_points.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::study {
namespace {

/// The beginning of shear ends at so many times the largest axial strain at onset: then the
/// runaway is a short piece of it.
constexpr double kOnsets = 2.5;

std::vector<lab::State> states_of_shear(const TestResult& test) {
  std::vector<lab::State> states;
  for (const auto& state : test.curves.states)
    if (is_shear(test.stored.header, state.stage)) states.push_back(state);
  return states;
}

void find_states_at_instants(SeriesTest& test) {
  test.at_onset = nearest_state(test.states, test.onset);
  test.at_loss_of_control = nearest_state(test.states, test.loss_of_control);
}

/// Tests of one name have their number with it.
void tell_apart(std::vector<SeriesTest>& series, const std::vector<TestResult>& tests) {
  std::map<std::string, int> count;
  for (const auto& test : series) ++count[test.name];
  for (std::size_t i = 0; i < series.size(); ++i)
    if (count[tests[i].stored.header.name] > 1)
      series[i].name += " (" + std::to_string(tests[i].stored.id) + ")";
}

double largest_axial_strain(const std::vector<TestResult>& tests) {
  double largest = 0;
  for (const auto& test : tests)
    for (const auto& state : test.curves.states)
      if (std::isfinite(state.strain.axial)) largest = std::max(largest, state.strain.axial);
  return largest;
}

}  // namespace

bool is_shear(const lab::RecordHeader& header, int stage) {
  const auto* info = header.stage(stage);
  return info == nullptr || info->role == lab::StageRole::shear ||
         info->role == lab::StageRole::unknown;
}

lab::Drainage drainage_of_shear(const lab::RecordHeader& header,
                                const std::vector<lab::State>& states) {
  constexpr double kMoved = 1e-3;
  if (states.empty()) return lab::Drainage::unknown;
  auto said = lab::Drainage::unknown;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const auto& state : states) {
    const auto* stage = header.stage(state.stage);
    if (stage != nullptr && stage->drainage != lab::Drainage::unknown &&
        said != lab::Drainage::open)
      said = stage->drainage;
    if (!std::isfinite(state.volumetric_strain)) continue;
    least = std::min(least, state.volumetric_strain);
    most = std::max(most, state.volumetric_strain);
  }
  if (said != lab::Drainage::unknown) return said;
  return most - least > kMoved ? lab::Drainage::open : lab::Drainage::closed;
}

std::optional<lab::State> nearest_state(const std::vector<lab::State>& states,
                                        const std::optional<lab::Instant>& instant) {
  if (!instant || states.empty()) return std::nullopt;
  return *std::ranges::min_element(states, {}, [&](const lab::State& state) {
    return std::llabs(state.reading - instant->reading);
  });
}

ShearSeries shear_series(const std::vector<TestResult>& tests) {
  ShearSeries series;
  for (const auto& test : tests) {
    auto& added = series.tests.emplace_back();
    added.name = test.stored.header.name;
    added.states = states_of_shear(test);
    added.breaks = test.curves.breaks;
    added.onset = collapse_onset(test.stored);
    added.loss_of_control = test.stored.summary.collapse.loss_of_control;
    find_states_at_instants(added);
    if (added.onset && added.onset->axial_strain)
      series.strain_at_onset = std::max(series.strain_at_onset, *added.onset->axial_strain);
  }
  tell_apart(series.tests, tests);
  auto points = collapse_points(tests);
  series.instability_lines = std::move(points.instability_lines);
  series.limit_stress_ratios = std::move(points.limit_stress_ratios);
  series.origin = origin_of(tests);
  return series;
}

ShearBeginnings shear_beginnings(const std::vector<TestResult>& tests) {
  ShearBeginnings beginnings{shear_series(tests), largest_axial_strain(tests)};
  auto& series = beginnings.series;
  double& last = beginnings.last_strain;
  if (series.strain_at_onset > 0) last = std::min(kOnsets * series.strain_at_onset, last);
  for (auto& test : series.tests) {
    const auto beyond = std::find_if(test.states.begin(), test.states.end(),
                                     [&](const auto& state) { return state.strain.axial > last; });
    test.states.erase(beyond, test.states.end());
    find_states_at_instants(test);
  }
  return beginnings;
}

}  // namespace triax::study
