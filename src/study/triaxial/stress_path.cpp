// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/stress_path.hpp"

#include "src/study/triaxial/shear_series.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::study {

std::optional<StressPoint> stress_at(const std::optional<lab::Instant>& instant) {
  if (!instant || !instant->eta()) return std::nullopt;
  return StressPoint{*instant->p_eff_pa, *instant->q_pa};
}

StressPath stress_path(const TestResult& test) {
  const auto& header = test.stored.header;
  const auto& summary = test.stored.summary;
  StressPath path;
  path.test = header.name;
  for (const auto& state : test.curves.states)
    (is_shear(header, state.stage) ? path.shear : path.before).push_back(state);
  path.breaks = test.curves.breaks;
  path.onset = stress_at(collapse_onset(test.stored));
  path.loss_of_control = stress_at(summary.collapse.loss_of_control);
  path.failure = stress_at(failure_onset(test.stored));
  if (const auto& truth = summary.truth; truth && truth->p_eff_pa && truth->q_pa)
    path.true_onset = {*truth->p_eff_pa, *truth->q_pa};
  path.limit_stress_ratio = summary.collapse.limit_stress_ratio;
  path.limit_intercept_pa = summary.collapse.limit_intercept_pa;
  path.origin.add(test.stored);
  return path;
}

}  // namespace triax::study
