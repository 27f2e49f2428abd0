// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/assessment.hpp"

#include <utility>

#include "lab/collapse/assessment_rules.hpp"

namespace triax::lab {
namespace {

/// The limit is known if its angle was given or the onset is on it.
void set_limit(const LimitSurface& limit, Collapse& c) {
  const bool is_known = limit.given() || c.inside_limit_surface == false;
  if (is_known) c.limit_stress_ratio = limit.stress_ratio();
  if (is_known) c.limit_intercept_pa = limit.intercept_pa();
  c.limit_source = limit.source(is_known);
}

}  // namespace

Collapse assess_by(std::span<const AssessmentRule> rules, const Evidence& e,
                   std::vector<Criterion> criteria) {
  DraftAssessment draft;
  draft.drained = !e.at_held_q && e.worst && e.worst->drained;
  draft.collapse.judged_from = e.first_state;
  draft.collapse.nearest = e.nearest;
  draft.collapse.criteria = std::move(criteria);
  for (const AssessmentRule& rule : rules) {
    if (!rule.applies(e, draft)) continue;
    rule.apply(e, draft);
    if (rule.is_final) break;
  }
  set_limit(e.limit, draft.collapse);
  return std::move(draft.collapse);
}

Collapse assess(const Evidence& evidence, std::vector<Criterion> criteria) {
  return assess_by(assessment_rules(), evidence, std::move(criteria));
}

}  // namespace triax::lab
