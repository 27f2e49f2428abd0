// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/assessment_rules.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "lab/collapse/criteria.hpp"
#include "lab/collapse/onset_interval.hpp"
#include "lab/collapse/second_order_work.hpp"
#include "lab/collapse/stress_span.hpp"
#include "lab/measured/assessment_limits.hpp"
#include "lab/measured/block_pyramid.hpp"
#include "lab/measured/instant.hpp"

namespace triax::lab {
namespace {

namespace limits = assessment_limits;
static_assert(limits::kStates == BlockPyramid::kBlocks);

CollapseKind kind_of(double loss, double regained) {
  if (loss < limits::kLossOfStrength) return CollapseKind::none;
  if (regained >= limits::kReturn) return CollapseKind::limited;
  return loss >= limits::kFlow ? CollapseKind::flow : CollapseKind::partial;
}

CollapseKind kind_of(const Descent& descent) {
  return kind_of(descent.strength_loss(), descent.strength_regained());
}

bool runaway_came_back(const Evidence& e) { return e.loss && e.loss->came_back(); }

CollapseKind kind_of_runaway(const Evidence& e) {
  return runaway_came_back(e) ? CollapseKind::limited : CollapseKind::flow;
}

/// A specimen that yielded at constant q and lost its q flows, unless it carried its q again.
CollapseKind kind_at_constant_q(const Evidence& e) {
  const double loss = e.worst ? e.worst->strength_loss() : 0;
  if (!e.loss_of_control && loss < limits::kLossOfStrength) return CollapseKind::none;
  const bool lost_q = e.worst && kind_of(*e.worst) == CollapseKind::flow;
  const bool caught = e.loss_of_control ? runaway_came_back(e) : e.at_held_q->came_back;
  return caught && !lost_q ? CollapseKind::limited : CollapseKind::flow;
}

/// The descent at constant q, if any, began before q itself was lost: it is the earlier onset.
const std::optional<Descent>& first_descent(const Evidence& e) {
  return e.at_held_q ? e.at_held_q : e.worst;
}

void take_descent(const Evidence& e, CollapseKind kind, DraftAssessment& draft) {
  const Descent& descent = *first_descent(e);
  Collapse& c = draft.collapse;
  c.kind = kind;
  c.onset = onset_of(descent, e.has_time);
  c.second_order_work_normalised = descent.evidence.work.normalised;
  c.second_order_work_error = descent.evidence.normalised_error;
  c.strength_lost = descent.strength_loss();
}

bool drained_peak(const Evidence& e) {
  const auto& descent = first_descent(e);
  return descent && descent->drained && descent->strength_loss() >= limits::kDrainedFailure &&
         descent->evidence.significantly_negative();
}

/// Beyond a few loops of unloading: q comes and goes, and the strain lags behind it.
bool is_cyclic(const Evidence& e) {
  const auto loading = e.cycles ? e.cycles->loading() : std::nullopt;
  return loading && loading->cycles >= limits::kCycles;
}

/// A loss from reading to reading that is no cycle.
bool lost_between_readings(const Evidence& e) { return e.backbone && !is_cyclic(e); }

/// The work of a finding that has no standard error, as evidence of the second-order work.
void prove(const std::string& evidence, Collapse& c) {
  Criterion& criterion = c.criteria.front();
  criterion.detected = true;
  criterion.reading = c.onset->reading;
  criterion.time_s = c.onset->time_s;
  criterion.eta = c.onset->eta();
  criterion.evidence = evidence;
}

void take_runaway(const Evidence& e, DraftAssessment& draft) {
  Collapse& c = draft.collapse;
  c.kind = kind_of_runaway(e);
  c.onset = e.loss_of_control->instant;
  if (c.kind == CollapseKind::limited) c.strength_lost = e.loss->lost();
}

double lost_by_runaway(const Evidence& e, const Collapse& c) {
  return 1 - e.loss->least() / std::fabs(*c.onset->q_pa);
}

/// The onset lies between the reading before its peak and the first without that strength.
Instant onset_of(const BackboneFall& fall, bool has_time) {
  Instant at = instant_of(fall.last_high, has_time);
  const double deviation = fall.noise / BendNoise::kOfDeviation;
  StressSpan span(*at.q_pa, *at.p_eff_pa);
  for (const State* state : {&fall.before_peak, &fall.peak, &fall.first_low})
    span.reach(state->q, state->p_eff);
  // Had it risen on as before, up to the next reading.
  span.reach_q(fall.peak.q + (fall.peak.q - fall.before_peak.q));
  at.interval = span.interval(error_of_readings(deviation * deviation, *at.q_pa, *at.p_eff_pa));
  return at;
}

std::string loss_in_words(const BackboneFall& fall) {
  return fmt::format(
      "q fell by {:.0f} %, from {:.2f} kPa at reading {} to {:.2f} kPa at reading {}",
      fall.loss() * 100, fall.peak.q / 1e3, fall.peak.reading, fall.least.q / 1e3,
      fall.least.reading);
}

void take_backbone(const Evidence& e, DraftAssessment& draft) {
  const BackboneFall& fall = *e.backbone;
  Collapse& c = draft.collapse;
  c.kind = kind_of(fall.loss(), fall.share_regained());
  c.onset = onset_of(fall, e.has_time);
  c.strength_lost = std::min(fall.loss(), 1.0);
  c.second_order_work_normalised = fall.normalised_work();
  prove(fmt::format(
            "normalised second-order work {:.3f} of the increment from reading {} to {}: {}; too "
            "few readings for a standard error: the onset is known to within {} readings",
            fall.normalised_work(), fall.last_high.reading, fall.least.reading, loss_in_words(fall),
            fall.readings + 1),
        c);
  draft.by_readings = true;
  draft.drained = fall.drained && !e.at_held_q;
}

/// True if the strength was lost before the first window of readings was full. A window gives no
/// onset before its own middle.
bool is_late(const Instant& onset, const BackboneFall& fall) {
  return fall.confirmed && onset.reading > fall.last_high.reading &&
         std::fabs(*onset.q_pa) < (1 - limits::kLossOfStrength) * std::fabs(fall.peak.q);
}

/// Second-order work was negative from there to the runaway, at constant q or because a frame let q
/// fall. Under another load the trend before a runaway is the servo's.
bool turned_before(const Descent& descent, const Instant& runaway) {
  const bool turned = !descent.settled && !descent.came_back &&
                      descent.evidence.significantly_negative() &&
                      descent.onset.reading < static_cast<double>(runaway.reading);
  const bool fell =
      descent.by_displacement && std::fabs(runaway.q_pa.value_or(0)) < descent.onset.strength();
  return turned && (descent.held_q || fell);
}

/// At constant q the interval reaches to the fall: the specimen follows the servo's search as well.
Instant onset_before(const Descent& descent, const std::optional<Instant>& fall, bool has_time) {
  Instant onset = onset_of(descent, has_time);
  if (descent.held_q && fall) reach(onset, *fall);
  return onset;
}

bool has_stress_ratio(const Collapse& c) { return c.onset && c.onset->eta(); }

void compare_with_limit(const Evidence& e, DraftAssessment& draft) {
  Collapse& c = draft.collapse;
  c.inside_limit_surface =
      e.limit.inside(*c.onset->q_pa, *c.onset->p_eff_pa, static_cast<double>(c.onset->reading));
  // A stress ratio of this test alone makes neither a runaway nor an undrained loss of a flow a
  // failure: if the pore pressure is stuck, dq = 3 dp′ gives a constant ratio up to any peak.
  const bool most = c.strength_lost.value_or(0) >= limits::kFlow && !draft.drained;
  if ((e.loss_of_control || most) && !e.limit.given() && c.inside_limit_surface == false)
    c.inside_limit_surface.reset();
}

bool is_drained_failure(const Evidence& e, const DraftAssessment& draft) {
  const Collapse& c = draft.collapse;
  if (!has_stress_ratio(c) || !draft.drained || e.loss_of_control) return false;
  return !c.inside_limit_surface && !e.limit.went_beyond(*c.onset->q_pa, *c.onset->p_eff_pa);
}

void call_failure(std::string_view words, Collapse& c) {
  c.kind = CollapseKind::none;
  c.criteria.front().detected = false;
  c.criteria.front().evidence += words;
}

std::string need_of_cohesion(const Evidence& e, const Collapse& c) {
  if (!c.detected() || !has_stress_ratio(c) || c.inside_limit_surface) return {};
  return e.limit.needs_cohesion(*c.onset->q_pa, *c.onset->p_eff_pa);
}

/// That may be the failure of a stiff clay, of a cemented soil or of rock.
void end_beyond_friction(const Evidence& e, Collapse& c) {
  const std::string reason = need_of_cohesion(e, c);
  const std::int64_t last = c.onset->reading;
  c.kind = CollapseKind::none;
  for (Criterion& one : c.criteria) one.detected.reset();
  c.end_at(last, reason);
}

std::optional<Moment> earlier(const std::optional<Moment>& a, const std::optional<Moment>& b) {
  if (!a || !b) return a ? a : b;
  return a->reading <= b->reading ? a : b;
}

void note_when_known(const Evidence& e, DraftAssessment& draft) {
  auto& known = draft.collapse.onset_detected_at;
  if (first_descent(e)) known = first_descent(e)->noticed;
  if (e.loss_of_control) known = earlier(known, e.loss_of_control->noticed);
  if (e.turned_at_held_q) known = earlier(known, e.control_peak->noticed);
  if (draft.by_readings) known = earlier(known, e.backbone->noticed);
}

void take_loss_of_control(const Finding& lost, Collapse& c) {
  c.loss_of_control = lost.instant;
  c.loss_of_control_detected_at = lost.noticed;
}

/// A permanent loss is no cyclic mobility: q does not turn at that strength again.
bool cycles_were_carried(const Evidence& e, const Collapse& c) {
  const auto loading = e.cycles ? e.cycles->loading() : std::nullopt;
  if (!loading || (!loading->liquefied && !loading->double_amplitude)) return false;
  const bool for_good = c.kind == CollapseKind::flow || c.kind == CollapseKind::partial;
  return !for_good || e.cycles->carried_on(c.onset->reading, *c.onset->q_pa);
}

/// The onset is the earlier one of the limit of liquefaction and the loss.
void take_cyclic_mobility(const Evidence& e, Collapse& c) {
  const CyclicLoading loading = *e.cycles->loading();
  const bool liquefied_first = loading.liquefied && (!loading.double_amplitude ||
                                                     loading.liquefied->instant.reading <=
                                                         loading.double_amplitude->instant.reading);
  const Instant& reached =
      (liquefied_first ? loading.liquefied : loading.double_amplitude)->instant;
  if (c.kind == CollapseKind::none || reached.reading < c.onset->reading) {
    c.onset = reached;
    c.onset_detected_at = Moment{reached.reading, reached.time_s};
    c.inside_limit_surface.reset();
    c.strength_lost.reset();
    c.second_order_work_normalised.reset();
    c.second_order_work_error.reset();
  }
  c.kind = CollapseKind::cyclic_mobility;
}

bool is_on_limit(const Evidence& e, const Instant& at) {
  return e.limit.inside(*at.q_pa, *at.p_eff_pa, static_cast<double>(at.reading)) == false;
}

bool ends_past_the_onset(const Evidence& e, const Collapse& c) {
  if (c.detected() || c.onset) return false;
  const auto& fall = e.latest;
  return fall && !fall->ended && !fall->drained && fall->evidence.significantly_negative() &&
         fall->strength_regained() < limits::kNoReturn &&
         !is_on_limit(e, onset_of(*fall, e.has_time));
}

bool ends_with_negative_work(const Evidence& e, const Collapse& c) {
  return !c.detected() && !c.onset && !ends_past_the_onset(e, c) && e.negative_at_end &&
         !is_cyclic(e) && !is_on_limit(e, *e.negative_at_end);
}

/// |q| fell at a constant axial strain: it is not known whether the specimen was deformed.
void end_at_doubtful_rest(const AxisRest::Fall& fall, Collapse& c) {
  c.kind = CollapseKind::none;
  c.end_at(
      fall.reading,
      fmt::format("q fell by {:.0f} % after reading {} while the axial strain did not move at "
                  "all. This is more than relaxation; the displacement transducer may be stuck",
                  fall.share * 100, fall.reading));
}

using Draft = DraftAssessment;

constexpr auto kRules = std::to_array<AssessmentRule>({
    {.name = "too few readings",
     .condition = "no window of complete states in shear is full, there is no runaway, and no "
                  "strength was lost between readings",
     .result = "not assessed",
     .applies =
         [](const Evidence& e, const Draft&) {
           return e.points == 0 && !e.loss_of_control && !lost_between_readings(e);
         },
     .apply =
         [](const Evidence& e, Draft& d) {
           Collapse& c = d.collapse;
           c.judged = false;
           c.judged_from.reset();
           c.judged_until_reason =
               fmt::format("too few readings in shear, {} complete states of the {} needed",
                           e.states, BlockPyramid::kBlocks);
           c.criteria = no_criteria("not assessed: " + c.judged_until_reason);
         },
     .is_final = true},
    {.name = "softening",
     .condition = "strength was lost while second-order work was negative, not at constant q",
     .result = "flow: half or more is lost and less than half of the loss returns. limited: half "
               "returns. partial: neither. Onset: second-order work vanishes",
     .applies =
         [](const Evidence& e, const Draft&) {
           return !e.at_held_q && e.worst && kind_of(*e.worst) != CollapseKind::none;
         },
     .apply = [](const Evidence& e, Draft& d) { take_descent(e, kind_of(*e.worst), d); }},
    {.name = "yielding at constant q",
     .condition = "second-order work was negative at constant q, and strength was lost or the "
                  "specimen ran away",
     .result = "flow; limited if the specimen carried its q again. Onset: second-order work "
               "vanishes",
     .applies =
         [](const Evidence& e, const Draft&) {
           return e.at_held_q && kind_at_constant_q(e) != CollapseKind::none;
         },
     .apply = [](const Evidence& e, Draft& d) { take_descent(e, kind_at_constant_q(e), d); }},
    {.name = "drained peak",
     .condition = "no collapse by the rows above, and past a drained peak second-order work was "
                  "negative beyond its error",
     .result = "none, with the onset of a failure",
     .applies = [](const Evidence& e,
                   const Draft& d) { return !d.collapse.detected() && drained_peak(e); },
     .apply = [](const Evidence& e, Draft& d) { take_descent(e, CollapseKind::none, d); }},
    {.name = "runaway",
     .condition = "no collapse by the rows above, and the specimen ran away",
     .result = "flow; limited if its strength returned. Onset: the runaway",
     .applies = [](const Evidence& e,
                   const Draft& d) { return !d.collapse.detected() && e.loss_of_control; },
     .apply = take_runaway},
    {.name = "runaway after softening",
     .condition = "partial, and a runaway without return took the loss of a flow; no cyclic test",
     .result = "flow",
     .applies =
         [](const Evidence& e, const Draft& d) {
           const Collapse& c = d.collapse;
           return c.kind == CollapseKind::partial && e.loss && !runaway_came_back(e) &&
                  !is_cyclic(e) && lost_by_runaway(e, c) >= limits::kFlow;
         },
     .apply =
         [](const Evidence& e, Draft& d) {
           d.collapse.kind = CollapseKind::flow;
           d.collapse.strength_lost = lost_by_runaway(e, d.collapse);
         }},
    {.name = "loss between readings",
     .condition = "no onset by the rows above; strength was lost from reading to reading, and a "
                  "second reading or a jump of the axial strain confirms it",
     .result = "flow, limited or partial, as for softening. Onset: the last reading near "
               "the peak",
     .applies =
         [](const Evidence& e, const Draft& d) {
           return !d.collapse.onset && lost_between_readings(e) && e.backbone->confirmed;
         },
     .apply = take_backbone},
    {.name = "loss in a single reading",
     .condition = "no onset by the rows above; a single reading shows a loss of strength",
     .result = "not assessed after the reading before it",
     .applies =
         [](const Evidence& e, const Draft& d) {
           return !d.collapse.onset && lost_between_readings(e) && !e.backbone->confirmed;
         },
     .apply =
         [](const Evidence& e, Draft& d) {
           d.collapse.end_at(e.backbone->last_high.reading,
                             loss_in_words(*e.backbone) + ", but only one reading shows it");
         }},
    {.name = "loss before the first window",
     .condition = "strength was lost from reading to reading before the onset found above",
     .result = "onset: the last reading near the peak",
     .applies =
         [](const Evidence& e, const Draft& d) {
           return d.collapse.onset && lost_between_readings(e) &&
                  is_late(*d.collapse.onset, *e.backbone);
         },
     .apply = [](const Evidence& e,
                 Draft& d) { d.collapse.onset = onset_of(*e.backbone, e.has_time); }},
    {.name = "fall",
     .condition = "there is an onset, and the specimen fell from one reading to the next",
     .result = "onset: the state at which equilibrium was lost",
     .applies = [](const Evidence& e, const Draft& d) { return d.collapse.onset && e.fall; },
     .apply = [](const Evidence& e, Draft& d) { d.collapse.onset = e.fall; }},
    {.name = "negative work before the runaway",
     .condition = "second-order work was negative beyond its error from an earlier reading to the "
                  "runaway, at constant q or while a frame let q fall",
     .result = "onset: second-order work vanishes",
     .applies =
         [](const Evidence& e, const Draft& d) {
           return d.collapse.onset && e.loss_of_control && e.worst &&
                  turned_before(*e.worst, *d.collapse.onset);
         },
     .apply = [](const Evidence& e,
                 Draft& d) { d.collapse.onset = onset_before(*e.worst, e.fall, e.has_time); }},
    {.name = "work of the fall",
     .condition = "no window shows negative second-order work, the readings of a fall do",
     .result = "second-order work of the fall",
     .applies =
         [](const Evidence& e, const Draft& d) {
           return d.collapse.onset && e.fall_work && !d.collapse.criteria.front().found();
         },
     .apply =
         [](const Evidence& e, Draft& d) {
           d.collapse.second_order_work_normalised = e.fall_work->normalised;
           d.collapse.second_order_work_error = e.fall_work->error;
           prove(e.fall_work->evidence, d.collapse);
         }},
    {.name = "turn of the pore pressure",
     .condition = "there is an onset; at constant q with closed drainage the pore pressure turned",
     .result = "onset: the turn of the pore pressure",
     .applies =
         [](const Evidence& e, const Draft& d) {
           return d.collapse.onset && e.volume_by_pore_pressure && e.control_peak;
         },
     .apply = [](const Evidence& e, Draft& d) { d.collapse.onset = e.control_peak->instant; }},
    {.name = "limit surface",
     .condition = "there is an onset with a stress ratio",
     .result = "inside the limit surface, on it, or unknown. A stress ratio of this test alone "
               "makes neither a runaway nor an undrained loss of a flow a failure",
     .applies = [](const Evidence&, const Draft& d) { return has_stress_ratio(d.collapse); },
     .apply = compare_with_limit},
    {.name = "failure on the limit surface",
     .condition = "the onset is on the limit surface",
     .result = "none: a failure",
     .applies = [](const Evidence&,
                   const Draft& d) { return d.collapse.inside_limit_surface == false; },
     .apply =
         [](const Evidence&, Draft& d) {
           call_failure("; a failure on the limit surface, not a collapse inside it", d.collapse);
         }},
    {.name = "failure past a drained peak",
     .condition = "strength was lost with open drainage under a prescribed displacement, without a "
                  "runaway, and no limit surface is known to lie above the onset",
     .result = "none: a failure",
     .applies = is_drained_failure,
     .apply = [](const Evidence&,
                 Draft& d) { call_failure("; a drained failure at the peak of q", d.collapse); }},
    {.name = "unknown cohesion",
     .condition = "the stress ratio of a collapse needs cohesion, and no limit is given",
     .result = "not assessed after the onset",
     .applies = [](const Evidence& e,
                   const Draft& d) { return !need_of_cohesion(e, d.collapse).empty(); },
     .apply = [](const Evidence& e, Draft& d) { end_beyond_friction(e, d.collapse); }},
    {.name = "time of detection",
     .condition = "there is a collapse",
     .result = "detected when the first of its findings was known",
     .applies = [](const Evidence&, const Draft& d) { return d.collapse.detected(); },
     .apply = note_when_known},
    {.name = "loss of control",
     .condition = "the specimen ran away, and did not carry a growing load afterwards",
     .result = "loss of control: the runaway, whatever the kind",
     .applies = [](const Evidence& e, const Draft&) { return e.loss_of_control.has_value(); },
     .apply = [](const Evidence& e,
                 Draft& d) { take_loss_of_control(*e.loss_of_control, d.collapse); }},
    {.name = "zero stress",
     .condition =
         "no runaway; p′ or q reached zero under a prescribed displacement; no cyclic test",
     .result = "loss of control: the first reading at zero",
     .applies = [](const Evidence& e,
                   const Draft&) { return !e.loss_of_control && e.zero_stress && !is_cyclic(e); },
     .apply = [](const Evidence& e,
                 Draft& d) { take_loss_of_control(*e.zero_stress, d.collapse); }},
    {.name = "zero stress without an onset",
     .condition = "the row above, and neither a collapse nor a failure was found",
     .result = "not assessed from that reading",
     .applies =
         [](const Evidence& e, const Draft& d) {
           return !e.loss_of_control && e.zero_stress && !is_cyclic(e) && !d.collapse.onset;
         },
     .apply =
         [](const Evidence& e, Draft& d) {
           d.collapse.end_at(e.zero_stress->instant.reading,
                             "the specimen lost all its stress, and no onset was found");
         }},
    {.name = "cyclic mobility",
     .condition = "cycles reached a limit of liquefaction and were carried afterwards",
     .result = "cyclic mobility. Onset: the first of the limit and the loss",
     .applies = [](const Evidence& e,
                   const Draft& d) { return cycles_were_carried(e, d.collapse); },
     .apply = [](const Evidence& e, Draft& d) { take_cyclic_mobility(e, d.collapse); }},
    {.name = "end past the onset",
     .condition = "no collapse and no failure; second-order work is negative beyond its error when "
                  "the record ends, undrained and not on the limit surface",
     .result = "not assessed after the possible onset",
     .applies = [](const Evidence& e,
                   const Draft& d) { return ends_past_the_onset(e, d.collapse); },
     .apply =
         [](const Evidence& e, Draft& d) {
           d.collapse.end_at(
               onset_of(*e.latest, e.has_time).reading,
               fmt::format("second-order work is negative when the record ends, {:.2g} % of q was "
                           "lost",
                           e.latest->strength_loss() * 100));
         }},
    {.name = "negative work at the end",
     .condition =
         "no collapse, no failure and no cyclic test; second-order work is negative in the "
         "last readings, not on the limit surface",
     .result = "not assessed after that reading",
     .applies = [](const Evidence& e,
                   const Draft& d) { return ends_with_negative_work(e, d.collapse); },
     .apply =
         [](const Evidence& e, Draft& d) {
           d.collapse.end_at(e.negative_at_end->reading,
                             "second-order work is negative in the last readings of the record");
         }},
    {.name = "loss at a constant strain",
     .condition = "no runaway; before any onset q fell by more than relaxation while the axial "
                  "strain stood still",
     .result = "not assessed after the reading before it",
     .applies =
         [](const Evidence& e, const Draft& d) {
           const auto& onset = d.collapse.onset;
           return e.fall_at_rest && !e.loss_of_control &&
                  (!onset || onset->reading > e.fall_at_rest->reading);
         },
     .apply = [](const Evidence& e,
                 Draft& d) { end_at_doubtful_rest(*e.fall_at_rest, d.collapse); }},
});

}  // namespace

std::span<const AssessmentRule> assessment_rules() { return kRules; }

}  // namespace triax::lab
