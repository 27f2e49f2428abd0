// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/sheared_test.hpp"

#include <algorithm>
#include <cmath>

#include "src/study/triaxial/shear_series.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::study {
namespace {

constexpr std::int64_t kStates = 20000;

/// Of the last stage of shear; what moved says it where the record does not.
lab::Drainage drainage_of(const ShearedTest& test, const lab::RecordHeader& header) {
  if (test.states.empty()) return lab::Drainage::unknown;
  const auto* stage = header.stage(test.states.back().stage);
  if (stage != nullptr && stage->drainage != lab::Drainage::unknown) return stage->drainage;
  double least = 0, most = 0;
  bool known = false;
  for (const auto& s : test.states) {
    if (!std::isfinite(s.volumetric_strain)) continue;
    known = true;
    least = std::min(least, s.volumetric_strain);
    most = std::max(most, s.volumetric_strain);
  }
  constexpr double kMoved = 1e-3;
  return known && most - least > kMoved ? lab::Drainage::open : lab::Drainage::closed;
}

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
  test.drainage = drainage_of(test, header);
  if (!test.void_ratio && !test.states.empty() && std::isfinite(test.states.front().void_ratio))
    test.void_ratio = test.states.front().void_ratio;
  return test;
}

}  // namespace triax::study
