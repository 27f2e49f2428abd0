// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/test_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "lab/measured/unread_steps.hpp"
#include "src/study/triaxial/read_again.hpp"

namespace triax::study {
namespace {

/// Fills the curves with states, thinned; the ends of an unread step and the first state of a fault
/// are kept.
void read_states(const db::Store& store, TestResult& test) {
  LineBreaks& breaks = test.curves.breaks;
  breaks.faults = faulty_spans(store, test.stored);
  const lab::RecordHeader& header = test.stored.header;
  const auto last = last_believed_reading(test.stored);
  CurveThinner thinner(store.scan_count(test.stored.id), kCurveBuckets);
  lab::UnreadSteps steps(header.has_time);
  lab::State before;
  bool was_faulty = false;
  store.for_each_scan(test.stored.id, 1, [&](const lab::Reading& read, const lab::State& as_read) {
    if (last && as_read.reading > *last) return;
    lab::State state = as_read;
    if (!breaks.faults.empty()) {
      lab::Reading reading = read;
      remove_faulty(breaks.faults, header, reading, state);
    }
    const bool unread = steps.add(state);
    if (unread) thinner.keep(before);
    thinner.add(state);
    const bool faulty = breaks.is_faulty(state.reading);
    if (unread || faulty != std::exchange(was_faulty, faulty)) thinner.keep(state);
    if (unread) breaks.unread_steps.push_back(state.reading);
    before = state;
  });
  test.curves.states = thinner.take();
}

}  // namespace

TestResult load_test_result(const db::Store& store, std::int64_t id, WithCurves with_curves) {
  TestResult test{store.load(id), {}};
  if (with_curves == WithCurves::no) return test;
  read_states(store, test);
  test.curves.work = thin(store.second_order_work(id), kCurveBuckets);
  test.curves.forecasts = thin(store.forecasts(id), kCurveBuckets);
  return test;
}

bool has_verdict(const db::StoredTest& test) {
  return test.status == db::TestStatus::complete && test.summary.collapse.judged;
}

std::optional<lab::Instant> collapse_onset(const db::StoredTest& test) {
  const auto& collapse = test.summary.collapse;
  return has_verdict(test) && collapse.detected() ? collapse.onset : std::nullopt;
}

std::optional<lab::Instant> failure_onset(const db::StoredTest& test) {
  const auto& collapse = test.summary.collapse;
  return has_verdict(test) && !collapse.detected() ? collapse.onset : std::nullopt;
}

std::optional<lab::Instant> true_loss_of_control(const lab::Truth& truth) {
  if (truth.run_aways.empty()) return std::nullopt;
  const lab::RunAwayTruth& first = truth.run_aways.front();
  // An onset at a fall is that instant.
  lab::Instant instant = first.start_s == truth.time_s ? true_instant(truth) : lab::Instant{};
  instant.time_s = first.start_s;
  if (first.axial_strain) instant.axial_strain = first.axial_strain;
  if (first.q_pa) instant.q_pa = first.q_pa;
  if (first.p_eff_pa) instant.p_eff_pa = first.p_eff_pa;
  if (first.pore_pressure_pa) instant.pore_pressure_pa = first.pore_pressure_pa;
  return instant;
}

lab::Instant true_instant(const lab::Truth& truth) {
  lab::Instant instant;
  instant.time_s = truth.time_s;
  instant.axial_strain = truth.axial_strain;
  instant.q_pa = truth.q_pa;
  instant.p_eff_pa = truth.p_eff_pa;
  instant.pore_pressure_pa = truth.pore_pressure_pa;
  return instant;
}

std::optional<std::int64_t> last_believed_reading(const db::StoredTest& test) {
  return has_sensor_faults(test) ? test.summary.collapse.judged_until : std::nullopt;
}

std::optional<double> void_ratio(const db::StoredTest& test) {
  if (test.summary.consolidation.void_ratio) return test.summary.consolidation.void_ratio;
  const auto& specimen = test.header.specimen;
  return specimen.consolidated_void_ratio ? specimen.consolidated_void_ratio : specimen.void_ratio;
}

std::vector<std::string> agreeing_criteria(const db::StoredTest& test) {
  std::vector<std::string> names;
  for (const auto& criterion : test.summary.collapse.criteria)
    if (criterion.found()) names.push_back(criterion.name);
  return names;
}

TestCounts counts_of(const std::vector<TestResult>& tests) {
  const auto left_out = read_again(tests);
  TestCounts counts;
  counts.read_again = static_cast<std::int64_t>(left_out.size());
  for (const auto& [test, curves] : tests) {
    if (left_out.contains(test.id)) continue;
    ++counts.tests;
    if (test.header.origin == lab::Origin::simulated) ++counts.simulated;
    if (test.status == db::TestStatus::interrupted) ++counts.interrupted;
  }
  return counts;
}

std::string in_words(const lab::Warning& warning) {
  return warning.line > 0 ? fmt::format("line {}: {}", warning.line, warning.text) : warning.text;
}

std::vector<std::string> warnings(const db::StoredTest& test) {
  std::vector<std::string> texts;
  for (const auto* list : {&test.header.warnings, &test.summary.warnings}) {
    for (const auto& warning : *list) {
      auto text = in_words(warning);
      if (std::find(texts.begin(), texts.end(), text) == texts.end())
        texts.push_back(std::move(text));
    }
  }
  return texts;
}

}  // namespace triax::study
