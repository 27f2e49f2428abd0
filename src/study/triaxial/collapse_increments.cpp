// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/collapse_increments.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "lab/measured/path_sampler.hpp"
#include "src/study/triaxial/read_again.hpp"

namespace triax::study {
namespace {

/// At held q the increment is that between the means of two spans of this share of the stage's
/// readings up to the onset: shorter ones follow the single steps of a pressure controller.
constexpr double kSpan = 0.05;

template <class Visit>
void visit_until(const db::Store& store, const db::StoredTest& test, std::int64_t onset,
                 const Visit& visit) {
  store.for_each_scan(test.id, 1, [&](const lab::Reading&, const lab::State& state) {
    if (state.reading <= onset) visit(state);
  });
}

std::optional<lab::MeasuredIncrement> measured(const db::Store& store, const db::StoredTest& test,
                                               std::int64_t onset, std::int64_t last) {
  lab::IncrementWatch watch(test.header, onset);
  visit_until(store, test, last, [&](const lab::State& state) { watch.watch(state); });
  return watch.finish();
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

/// Mean of one signal, and the square of its standard error.
struct Mean {
  double value = 0, square = 0;
  double count = 0;
  void add(double next) {
    const double off = next - value;
    value += off / ++count;
    square += off * (next - value);
  }
  double error2() const { return count > 1 ? square / (count - 1) / count : 0; }
};

struct SpanMeans {
  Mean q, p, axial, volumetric;
  void add(const lab::State& state) {
    q.add(state.q);
    p.add(state.p_eff);
    axial.add(state.strain.axial);
    volumetric.add(state.volumetric_strain);
  }
};

std::optional<lab::MeasuredIncrement> between(const SpanMeans& before, const SpanMeans& last) {
  const lab::PathStep step{last.q.value - before.q.value, last.p.value - before.p.value,
                           last.axial.value - before.axial.value,
                           last.volumetric.value - before.volumetric.value};
  const double q2 = last.q.error2() + before.q.error2(), p2 = last.p.error2() + before.p.error2();
  const double axial2 = last.axial.error2() + before.axial.error2();
  const double volumetric2 = last.volumetric.error2() + before.volumetric.error2();
  // Variances of (p′, q) and of the strains as vectors: 3 dp² + ⅔ dq², ⅓ dε_v² + 3/2 dε_q².
  const double normalised_error = lab::direction_error(
      step, 3 * p2 + 2 * q2 / 3, volumetric2 / 3 + 1.5 * (axial2 + volumetric2 / 9));
  return lab::increment_of(step, std::sqrt(p2), std::sqrt(q2), normalised_error,
                           std::llround(last.q.count + before.q.count));
}

/// Between the means of the last span and of the one before it; nothing where a span is empty.
std::optional<lab::MeasuredIncrement> secant(const db::Store& store, const db::StoredTest& test,
                                             std::int64_t onset, std::int64_t start) {
  const auto span = std::llround(kSpan * static_cast<double>(onset - start));
  SpanMeans before, last;
  visit_until(store, test, onset, [&](const lab::State& state) {
    if (!lab::complete(state)) return;
    if (state.reading > onset - span)
      last.add(state);
    else if (state.reading > onset - 2 * span)
      before.add(state);
  });
  if (before.q.count == 0 || last.q.count == 0) return std::nullopt;
  return between(before, last);
}

}  // namespace

std::optional<lab::MeasuredIncrement> increment_towards(const db::Store& store,
                                                        const db::StoredTest& test,
                                                        std::int64_t onset) {
  const Stage stage = stage_of(store, test, onset);
  const auto* info = test.header.stage(stage.number);
  if (info != nullptr && info->control == lab::AxialControl::constant_q)
    return secant(store, test, onset, stage.start);
  const bool driven = info != nullptr && info->control == lab::AxialControl::displacement;
  return measured(store, test, onset, driven ? std::numeric_limits<std::int64_t>::max() : onset);
}

std::vector<CollapseIncrement> collapse_increments(const db::Store& store,
                                                   const std::vector<std::int64_t>& ids) {
  std::vector<TestResult> tests;
  tests.reserve(ids.size());
  for (const auto id : ids) tests.push_back(load_test_result(store, id, WithCurves::no));
  const auto left_out = read_again(tests);
  std::vector<CollapseIncrement> increments;
  for (const auto& [test, curves] : tests) {
    if (left_out.contains(test.id)) continue;
    if (test.summary.collapse.kind == lab::CollapseKind::cyclic_mobility) continue;
    const auto onset = collapse_onset(test);
    if (!onset || !onset->eta()) continue;
    const auto increment = increment_towards(store, test, onset->reading);
    if (!increment || !increment->has_direction()) continue;
    increments.push_back({.test = test.header.name,
                          .programme = test.header.programme,
                          .p_pa = *onset->p_eff_pa,
                          .q_pa = *onset->q_pa,
                          .dp = increment->rate.p,
                          .dq = increment->rate.q});
  }
  return increments;
}

}  // namespace triax::study
