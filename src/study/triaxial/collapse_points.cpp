// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/collapse_points.hpp"

#include <cmath>
#include <cstdint>
#include <map>

#include "src/study/triaxial/read_again.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::study {
namespace {

std::vector<double> fitted_slopes(const std::vector<CollapsePoint>& points) {
  std::vector<double> slopes;
  for (const bool extension : {false, true}) {
    double qp = 0, pp = 0;
    for (const auto& [stress, test, programme, simulated] : points) {
      if ((stress.q_pa < 0) != extension) continue;
      const double p = stress.p_pa * 1e-3, q = stress.q_pa * 1e-3;
      qp += q * p;
      pp += p * p;
    }
    if (pp > 0) slopes.push_back(qp / pp);
  }
  return slopes;
}

std::vector<double> limits_of(const std::vector<TestResult>& tests,
                              const std::set<std::int64_t>& left_out) {
  std::map<std::int64_t, double> by_rounded;
  for (const auto& test : tests)
    if (const auto& m = test.stored.summary.collapse.limit_stress_ratio;
        m && !test.stored.summary.collapse.limit_intercept_pa && std::isfinite(*m) &&
        collapse_onset(test.stored) && !left_out.contains(test.stored.id))
      by_rounded.emplace(std::llround(*m * 100), *m);
  std::vector<double> values;
  values.reserve(by_rounded.size());
  for (const auto& [rounded, m] : by_rounded) values.push_back(m);
  return values;
}

}  // namespace

CollapsePoints collapse_points(const std::vector<TestResult>& tests) {
  const auto left_out = read_again(tests);
  CollapsePoints found;
  for (const auto& [test, curves] : tests) {
    // Where cycles liquefied a specimen says nothing of where monotonic shear loses it.
    if (test.summary.collapse.kind == lab::CollapseKind::cyclic_mobility) continue;
    const auto stress = stress_at(collapse_onset(test));
    if (!stress || left_out.contains(test.id)) continue;
    const auto& header = test.header;
    found.points.push_back({*stress, header.name,
                            header.programme.empty() ? "other" : header.programme,
                            header.origin == lab::Origin::simulated});
    found.origin.add(test);
  }
  found.instability_lines = fitted_slopes(found.points);
  found.limit_stress_ratios = limits_of(tests, left_out);
  return found;
}

}  // namespace triax::study
