// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/sheared_test.hpp"

#include <algorithm>
#include <cmath>

#include "src/study/triaxial/shear_series.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::study {
namespace {

constexpr std::int64_t kStates = 20000;

}  // namespace

ShearedTest load_sheared_test(const db::Store& store, std::int64_t id) {
  const db::StoredTest stored = store.load(id);
  const auto& header = stored.header;
  ShearedTest test{.id = id,
                   .name = header.name,
                   .material = header.specimen.material,
                   .programme = header.programme,
                   .digest = header.digest,
                   .simulated = header.origin == lab::Origin::simulated,
                   .complete = stored.status == db::TestStatus::complete,
                   .void_ratio = void_ratio(stored),
                   .p_eff_pa = stored.summary.consolidation.p_eff_pa,
                   .onset = collapse_onset(stored),
                   .cyclic = stored.summary.cyclic};
  if (has_verdict(stored)) test.collapse = stored.summary.collapse.kind;
  const std::int64_t every = std::max<std::int64_t>(1, store.scan_count(id) / kStates);
  store.for_each_scan(id, every, [&](const lab::Reading&, const lab::State& state) {
    if (is_shear(header, state.stage)) test.states.push_back(state);
  });
  test.drainage = drainage_of_shear(header, test.states);
  if (!test.void_ratio && !test.states.empty() && std::isfinite(test.states.front().void_ratio))
    test.void_ratio = test.states.front().void_ratio;
  return test;
}

}  // namespace triax::study
