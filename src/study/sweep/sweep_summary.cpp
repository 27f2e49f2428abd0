// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sweep/sweep_summary.hpp"

#include <cmath>

namespace triax::study {
namespace {

void add_finite(std::vector<double>& values, const std::optional<double>& value) {
  if (value && std::isfinite(*value)) values.push_back(*value);
}

}  // namespace

bool collapse_detected(const SweepMember& member) {
  return member.judged && member.kind != lab::CollapseKind::none;
}

SweepSummary summary_of(const std::vector<SweepMember>& members) {
  SweepSummary sum;
  std::vector<double> eta, true_eta, eta_error;
  for (const SweepMember& m : members) {
    const bool stored = m.id.has_value(), failed = !m.failure.empty();
    const bool detected = collapse_detected(m);
    ++sum.tests;
    sum.stored += stored ? 1 : 0;
    sum.failed += failed ? 1 : 0;
    sum.not_run += !stored && !failed ? 1 : 0;
    sum.judged += m.judged ? 1 : 0;
    sum.detected += detected ? 1 : 0;
    sum.truly_lost += stored && m.truly_lost ? 1 : 0;
    sum.truly_lost_detected += m.truly_lost && detected ? 1 : 0;
    sum.false_alarms += !m.truly_lost && detected ? 1 : 0;
    add_finite(eta, m.eta);
    add_finite(true_eta, m.true_eta);
    if (m.eta && m.true_eta) add_finite(eta_error, *m.eta - *m.true_eta);
  }
  sum.eta = spread_of(eta);
  sum.true_eta = spread_of(true_eta);
  sum.eta_error = spread_of(eta_error);
  return sum;
}

}  // namespace triax::study
