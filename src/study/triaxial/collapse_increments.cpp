// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/collapse_increments.hpp"

#include <cmath>
#include <optional>

#include "lab/collapse/measured_increment.hpp"
#include "src/study/triaxial/read_again.hpp"

namespace triax::study {
namespace {

/// At held q the increment is that between the means of two spans of this share of the stage's
/// readings up to the onset: shorter ones follow the single steps of a pressure controller.
constexpr double kSpan = 0.05;

struct Direction {
  double dp = 0, dq = 0;
};

/// From the readings up to the onset only: what follows may be a fall within one reading, which
/// says nothing of how it came to it.
template <class Visit>
void visit_until(const db::Store& store, const db::StoredTest& test, std::int64_t onset,
                 const Visit& visit) {
  store.for_each_scan(test.id, 1, [&](const lab::Reading&, const lab::State& state) {
    if (state.reading <= onset) visit(state);
  });
}

std::optional<Direction> measured(const db::Store& store, const db::StoredTest& test,
                                  std::int64_t onset) {
  lab::IncrementWatch watch(test.header, onset);
  visit_until(store, test, onset, [&](const lab::State& state) { watch.watch(state); });
  const auto increment = watch.finish();
  if (!increment || !increment->has_direction()) return std::nullopt;
  return Direction{increment->rate.p, increment->rate.q};
}

struct Stage {
  int number = 0;
  std::int64_t start = 0;  ///< its first reading
};

/// In which the onset lies.
Stage stage_of(const db::Store& store, const db::StoredTest& test, std::int64_t onset) {
  std::optional<Stage> stage;
  visit_until(store, test, onset, [&](const lab::State& state) {
    if (!stage || stage->number != state.stage) stage = {state.stage, state.reading};
  });
  return stage.value_or(Stage{});
}

struct Mean {
  double p = 0, q = 0;
  std::int64_t count = 0;
  void add(const lab::State& state) {
    p += state.p_eff;
    q += state.q;
    ++count;
  }
};

/// Between the means of the last span and of the one before it; nothing where a span is empty.
std::optional<Direction> secant(const db::Store& store, const db::StoredTest& test,
                                std::int64_t onset, std::int64_t start) {
  const auto span = std::llround(kSpan * static_cast<double>(onset - start));
  Mean before, last;
  visit_until(store, test, onset, [&](const lab::State& state) {
    if (!std::isfinite(state.p_eff) || !std::isfinite(state.q)) return;
    if (state.reading > onset - span)
      last.add(state);
    else if (state.reading > onset - 2 * span)
      before.add(state);
  });
  if (before.count == 0 || last.count == 0) return std::nullopt;
  const auto n = static_cast<double>(last.count), m = static_cast<double>(before.count);
  return Direction{last.p / n - before.p / m, last.q / n - before.q / m};
}

std::optional<Direction> direction(const db::Store& store, const db::StoredTest& test,
                                   std::int64_t onset) {
  const Stage stage = stage_of(store, test, onset);
  const auto* info = test.header.stage(stage.number);
  if (info != nullptr && info->control == lab::AxialControl::constant_q)
    return secant(store, test, onset, stage.start);
  return measured(store, test, onset);
}

}  // namespace

std::vector<CollapseIncrement> collapse_increments(const db::Store& store,
                                                   const std::vector<std::int64_t>& ids) {
  std::vector<TestResult> tests;
  for (const auto id : ids) tests.push_back(load_test_result(store, id, WithCurves::no));
  const auto left_out = read_again(tests);
  std::vector<CollapseIncrement> increments;
  for (const auto& [test, curves] : tests) {
    if (left_out.contains(test.id)) continue;
    const auto onset = collapse_onset(test);
    if (!onset || !onset->eta()) continue;
    const auto increment = direction(store, test, onset->reading);
    if (!increment) continue;
    increments.push_back({.test = test.header.name,
                          .programme = test.header.programme,
                          .p_pa = *onset->p_eff_pa,
                          .q_pa = *onset->q_pa,
                          .dp = increment->dp,
                          .dq = increment->dq});
  }
  return increments;
}

}  // namespace triax::study
