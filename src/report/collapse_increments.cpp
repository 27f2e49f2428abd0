#include "src/report/collapse_increments.hpp"

#include "lab/collapse/measured_increment.hpp"
#include "src/report/reported_test.hpp"

namespace triax::src {
namespace {

/// Of the direction of an increment: beyond it, it could be any.
const double kLargestError = sim::radians(45);

}  // namespace

std::vector<CollapseIncrement> collapse_increments(const db::Store& store,
                                                   const std::vector<std::int64_t>& ids) {
  std::vector<CollapseIncrement> increments;
  for (const auto id : ids) {
    const db::StoredTest test = store.load(id);
    const auto onset = collapse_onset(test);
    if (!onset || !onset->eta()) continue;
    lab::IncrementWatch watch(test.header, onset->reading);
    store.for_each_scan(id, 1,
                        [&](const lab::Reading&, const lab::State& state) { watch.watch(state); });
    const auto increment = watch.finish();
    if (!increment || !(increment->angle_error < kLargestError)) continue;
    increments.push_back({.test = test.header.name,
                          .programme = test.header.programme,
                          .p_pa = *onset->p_eff_pa,
                          .q_pa = *onset->q_pa,
                          .dp = increment->rate.p,
                          .dq = increment->rate.q});
  }
  return increments;
}

}  // namespace triax::src
