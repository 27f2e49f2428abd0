// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/verdict.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lab/collapse/criteria.hpp"
#include "lab/collapse/onset_interval.hpp"
#include "lab/collapse/second_order_work.hpp"
#include "lab/collapse/stress_span.hpp"
#include "lab/measured/instant.hpp"

namespace triax::lab {
namespace {

static_assert(Backbone::kWorth == Descent::kWorthALoss, "a loss is worth the same in both");

constexpr double kFlowLoss = 0.5;
/// Share of the strength from which a drained peak is told as a failure.
constexpr double kFailureLoss = 0.02;
/// Share of a loss that noise may seem to bring back while q still falls.
constexpr double kNotTurned = 0.1;

CollapseKind kind_of(double loss, double regained) {
  if (loss < Descent::kWorthALoss) return CollapseKind::none;
  if (regained >= 0.5) return CollapseKind::limited;
  return loss >= kFlowLoss ? CollapseKind::flow : CollapseKind::partial;
}

CollapseKind kind_of(const Descent& descent) {
  return kind_of(descent.strength_loss(), descent.strength_regained());
}

bool runaway_came_back(const Evidence& e) { return e.loss && e.loss->came_back(); }

/// A specimen that yielded at held q and lost it flows, unless it caught itself with its q. One
/// that carried q to the end of the stage was controlled.
CollapseKind kind_at_held_q(const Evidence& e) {
  const double loss = e.worst ? e.worst->strength_loss() : 0;
  if (!e.loss_of_control && loss < Descent::kWorthALoss) return CollapseKind::none;
  const bool lost_q = e.worst && kind_of(*e.worst) == CollapseKind::flow;
  const bool caught = e.loss_of_control ? runaway_came_back(e) : e.at_held_q->came_back;
  return caught && !lost_q ? CollapseKind::limited : CollapseKind::flow;
}

/// The windows before the fall say nothing, the fall itself does.
void prove_by_fall(const FallWork& work, Collapse& c) {
  c.second_order_work_normalised = work.normalised;
  c.second_order_work_error = work.error;
  Criterion& criterion = c.criteria.front();
  criterion.detected = true;
  criterion.reading = c.onset->reading;
  criterion.time_s = c.onset->time_s;
  criterion.eta = c.onset->eta();
  criterion.evidence = work.evidence;
}

/// The limit is known if its angle was given or the onset lies on it.
void set_limit(const LimitSurface& limit, Collapse& c) {
  const bool is_known = limit.given() || c.inside_limit_surface == false;
  if (is_known) c.limit_stress_ratio = limit.stress_ratio();
  if (is_known) c.limit_intercept_pa = limit.intercept_pa();
  c.limit_source = limit.source(is_known);
}

/// Too little was seen of shear: nothing is known, which is not the same as no collapse.
Collapse not_judged(const Evidence& e) {
  Collapse c;
  c.judged = false;
  c.judged_until_reason =
      fmt::format("too few readings in shear, {} complete states of the {} needed", e.states,
                  static_cast<int>(BlockPyramid::kBlocks));
  set_limit(e.limit, c);
  c.criteria = no_criteria("not assessed: " + c.judged_until_reason);
  return c;
}

void take_descent(const Evidence& e, const Descent& descent, Collapse& c) {
  c.kind = e.at_held_q ? kind_at_held_q(e) : kind_of(descent);
  const bool failed = descent.drained && descent.strength_loss() >= kFailureLoss &&
                      descent.evidence.significantly_negative();
  if (c.kind == CollapseKind::none && !failed) return;
  c.onset = onset_of(descent, e.has_time);
  c.second_order_work_normalised = descent.evidence.work.normalised;
  c.second_order_work_error = descent.evidence.normalised_error;
  c.strength_lost = descent.strength_loss();
}

/// What strength was lost on the limit surface, or by a drained peak of which nobody knows that it
/// lies inside, is a failure and no collapse.
void tell_failures_apart(const Evidence& e, bool drained, Collapse& c) {
  if (!c.onset || !c.onset->eta()) return;
  const double q = *c.onset->q_pa, p_eff = *c.onset->p_eff_pa;
  c.inside_limit_surface = e.limit.inside(q, p_eff, static_cast<double>(c.onset->reading));
  // A runaway that was seen is excused by a limit that is known, and by no ratio of the test's own.
  // Nor is most of an undrained strength: with the pore pressure dead, dq = 3 dp′ walks along a
  // limit of its own up to any peak.
  const bool most = c.strength_lost.value_or(0) >= kFlowLoss && !drained;
  if ((e.loss_of_control || most) && !e.limit.given() && c.inside_limit_surface == false)
    c.inside_limit_surface.reset();
  const bool on_limit = c.inside_limit_surface == false;
  const bool below_limit = c.inside_limit_surface == true || e.limit.went_beyond(q, p_eff);
  const bool drained_failure = drained && !e.loss_of_control && !below_limit;
  if (!on_limit && !drained_failure) return;
  c.kind = CollapseKind::none;
  c.criteria.front().detected = false;
  c.criteria.front().evidence += on_limit
                                     ? "; a failure on the limit surface, not a collapse inside it"
                                     : "; a drained failure at the peak of q";
}

/// Strength was lost at a ratio that needs cohesion, of which nothing is known: that may be the
/// failure of a stiff clay, of a cemented soil or of rock.
void end_beyond_friction(const LimitSurface& limit, Collapse& c) {
  if (!c.detected() || !c.onset || !c.onset->eta() || c.inside_limit_surface) return;
  const std::string reason = limit.needs_cohesion(*c.onset->q_pa, *c.onset->p_eff_pa);
  if (reason.empty()) return;
  const std::int64_t last = c.onset->reading;
  c.kind = CollapseKind::none;
  for (Criterion& one : c.criteria) one.detected.reset();
  c.end_at(last, reason);
  c.second_order_work_normalised.reset();
  c.second_order_work_error.reset();
  c.strength_lost.reset();
}

/// Second-order work was negative from there to the runaway, at held q or because a frame let q
/// fall: that is the onset. Under another load the trend before a runaway is the servo's.
bool turned_before(const Descent& descent, const Instant& runaway) {
  const bool turned = !descent.settled && !descent.came_back &&
                      descent.evidence.significantly_negative() &&
                      descent.onset.reading < static_cast<double>(runaway.reading);
  const bool fell =
      descent.by_displacement && std::fabs(runaway.q_pa.value_or(0)) < descent.onset.strength();
  return turned && (descent.held_q || fell);
}

/// At held q the interval reaches to the fall: the specimen follows the servo's search as well.
Instant onset_before(const Descent& descent, const std::optional<Instant>& fall, bool has_time) {
  Instant onset = onset_of(descent, has_time);
  if (descent.held_q && fall) reach(onset, *fall);
  return onset;
}

/// Beyond a few loops of unloading: q comes and goes, and the strain lags behind it.
bool is_cyclic(const Evidence& e) {
  constexpr double kCycles = 4;
  const auto loading = e.cycles ? e.cycles->loading() : std::nullopt;
  return loading && loading->cycles >= kCycles;
}

/// What began as a descent ended in a fall.
void take_fall_after(const Evidence& e, Collapse& c) {
  if (c.kind != CollapseKind::partial || !e.loss || runaway_came_back(e) || is_cyclic(e)) return;
  const double lost = 1 - e.loss->least() / std::fabs(*c.onset->q_pa);
  if (!(lost >= kFlowLoss)) return;
  c.kind = CollapseKind::flow;
  c.strength_lost = lost;
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

std::optional<Moment> earlier(const std::optional<Moment>& a, const std::optional<Moment>& b) {
  if (!a || !b) return a ? a : b;
  return a->reading <= b->reading ? a : b;
}

/// When the first of what the verdict rests on was known.
void note_when_known(const Evidence& e, const std::optional<Descent>& descent, bool by_backbone,
                     Collapse& c) {
  if (!c.detected()) return;
  if (descent) c.onset_detected_at = descent->noticed;
  if (e.loss_of_control)
    c.onset_detected_at = earlier(c.onset_detected_at, e.loss_of_control->noticed);
  if (e.turned_at_held_q)
    c.onset_detected_at = earlier(c.onset_detected_at, e.control_peak->noticed);
  if (by_backbone) c.onset_detected_at = earlier(c.onset_detected_at, e.backbone->noticed);
}

/// Independent of the kind of collapse and of its onset.
void set_loss_of_control(const Evidence& e, Collapse& c) {
  const std::optional<Finding>& lost = e.loss_of_control ? e.loss_of_control : e.zero_stress;
  if (!lost || (!e.loss_of_control && is_cyclic(e))) return;
  c.loss_of_control = lost->instant;
  c.loss_of_control_detected_at = lost->noticed;
}

/// Strength was lost that no window of readings saw go.
void take_backbone(const Evidence& e, const BackboneFall& fall, Collapse& c) {
  const std::string lost =
      fmt::format("q fell by {:.0f} %, from {:.2f} kPa at reading {} to {:.2f} kPa at reading {}",
                  fall.loss() * 100, fall.peak.q / 1e3, fall.peak.reading, fall.least.q / 1e3,
                  fall.least.reading);
  if (!fall.confirmed) {
    c.end_at(fall.last_high.reading, lost + ", but only one reading shows it");
    return;
  }
  c.kind = kind_of(fall.loss(), fall.share_regained());
  c.onset = onset_of(fall, e.has_time);
  c.strength_lost = std::min(fall.loss(), 1.0);
  c.second_order_work_normalised = fall.normalised_work();
  Criterion& criterion = c.criteria.front();
  criterion.detected = true;
  criterion.reading = c.onset->reading;
  criterion.time_s = c.onset->time_s;
  criterion.eta = c.onset->eta();
  criterion.evidence = fmt::format(
      "normalised second-order work {:.3f} of the increment from reading {} to {}: {}; too few "
      "readings for a standard error: the onset is known to within {} readings",
      fall.normalised_work(), fall.last_high.reading, fall.least.reading, lost, fall.readings + 1);
}

/// Whether the strength had gone before the first window of readings was full, which places no
/// onset before its own middle.
bool is_late(const Instant& onset, const BackboneFall& fall) {
  return fall.confirmed && onset.reading > fall.last_high.reading &&
         std::fabs(*onset.q_pa) < (1 - Backbone::kWorth) * std::fabs(fall.peak.q);
}

/// Cycles that liquefied the specimen, of which each was carried all the same. What is lost for
/// good is that: q does not turn at that strength again. The onset is the first of what was reached
/// and of what was lost.
void tell_cyclic_mobility(const CycleCounter& cycles, Collapse& c) {
  const auto loading = cycles.loading();
  if (!loading || (!loading->liquefied && !loading->double_amplitude)) return;
  const bool for_good = c.kind == CollapseKind::flow || c.kind == CollapseKind::partial;
  if (for_good && !cycles.carried_on(c.onset->reading, *c.onset->q_pa)) return;
  const bool liquefied_first =
      loading->liquefied &&
      (!loading->double_amplitude ||
       loading->liquefied->instant.reading <= loading->double_amplitude->instant.reading);
  const Instant& reached =
      (liquefied_first ? loading->liquefied : loading->double_amplitude)->instant;
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

/// |q| fell by much while the axial strain stood: who knows whether the specimen did.
void end_at_doubtful_rest(const AxisRest::Fall& fall, Collapse& c) {
  if (c.onset && c.onset->reading <= fall.reading) return;
  const std::string reason = fmt::format(
      "q fell by {:.0f} % after reading {} while the axial strain did not move at all. This is "
      "more than relaxation; the displacement transducer may be stuck",
      fall.share * 100, fall.reading);
  c.kind = CollapseKind::none;
  c.end_at(fall.reading, reason);
}

bool is_on_limit(const Evidence& e, const Instant& at) {
  return e.limit.inside(*at.q_pa, *at.p_eff_pa, static_cast<double>(at.reading)) == false;
}

/// Ends the assessment if the record ended just past an onset, before anything was lost.
void end_past_the_onset(const Evidence& e, Collapse& c) {
  if (c.detected() || c.onset) return;
  if (const auto& fall = e.latest; fall && !fall->ended && !fall->drained &&
                                   fall->evidence.significantly_negative() &&
                                   fall->strength_regained() < kNotTurned) {
    const Instant onset = onset_of(*fall, e.has_time);
    if (!is_on_limit(e, onset))
      return c.end_at(onset.reading,
                      fmt::format("second-order work is negative when the record ends, {:.2g} % of "
                                  "q was lost",
                                  fall->strength_loss() * 100));
  }
  if (e.turned_at_end && !is_on_limit(e, *e.turned_at_end))
    c.end_at(e.turned_at_end->reading,
             "second-order work at constant q is negative in the last readings of the record");
}

}  // namespace

Collapse assess(const Evidence& e, std::vector<Criterion> criteria) {
  const bool few = e.backbone && !is_cyclic(e);
  if (e.points == 0 && !e.loss_of_control && !few) return not_judged(e);
  Collapse c;
  c.judged_from = e.first_state;
  c.nearest = e.nearest;
  c.criteria = std::move(criteria);

  // The descent at held q, if any, began before q itself was lost: it is the earlier onset.
  const auto& descent = e.at_held_q ? e.at_held_q : e.worst;
  if (descent) take_descent(e, *descent, c);

  if (c.kind == CollapseKind::none && e.loss_of_control) {
    // Over before any window was full: the burst itself is the evidence.
    c.kind = runaway_came_back(e) ? CollapseKind::limited : CollapseKind::flow;
    c.onset = e.loss_of_control->instant;
    if (c.kind == CollapseKind::limited) c.strength_lost = e.loss->lost();
  }
  take_fall_after(e, c);
  const bool by_backbone = !c.onset && few;
  if (by_backbone) take_backbone(e, *e.backbone, c);
  if (few && c.onset && is_late(*c.onset, *e.backbone)) c.onset = onset_of(*e.backbone, e.has_time);
  if (c.onset && e.fall) c.onset = e.fall;
  if (c.onset && e.loss_of_control && e.worst && turned_before(*e.worst, *c.onset))
    c.onset = onset_before(*e.worst, e.fall, e.has_time);
  if (c.onset && e.fall_work && !c.criteria.front().found()) prove_by_fall(*e.fall_work, c);
  if (c.onset && e.volume_by_pore_pressure && e.control_peak) c.onset = e.control_peak->instant;
  const bool drained = by_backbone ? e.backbone->drained : descent && descent->drained;
  tell_failures_apart(e, drained && !e.at_held_q, c);
  end_beyond_friction(e.limit, c);
  note_when_known(e, descent, by_backbone, c);
  set_loss_of_control(e, c);
  if (e.cycles) tell_cyclic_mobility(*e.cycles, c);
  end_past_the_onset(e, c);
  // A runaway that was seen is never withdrawn.
  if (e.fall_at_rest && !e.loss_of_control) end_at_doubtful_rest(*e.fall_at_rest, c);
  set_limit(e.limit, c);
  return c;
}

}  // namespace triax::lab
