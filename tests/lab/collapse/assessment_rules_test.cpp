// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the table of rules: a case that needs it, whose result is another without the row,
// and a case that contradicts it, whose result is the same without it.
#include "lab/collapse/assessment_rules.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <functional>
#include <map>

#include "lab/collapse/criteria.hpp"
#include "tests/lab/collapse/evidence_samples.hpp"

using namespace triax::lab;

namespace rule_cases {
namespace {

const LimitSurface& unknown_limit() {
  static const LimitSurface limit({});
  return limit;
}

const LimitSurface& sand() {
  static const LimitSurface limit = samples::sand();
  return limit;
}

Descent descent(double q_onset, double p_eff, double q_lost, double q_regained) {
  Descent d = samples::descent(q_onset, p_eff, q_lost, q_regained);
  d.evidence.normalised_error = 0.02;
  d.noticed = Moment{15, std::nullopt};
  return d;
}

Descent drained(Descent d) {
  d.drained = true;
  return d;
}

Descent at_constant_q(Descent d) {
  d.held_q = true;
  return d;
}

Finding finding(std::int64_t reading, double q, double p_eff) {
  return {.instant = {.reading = reading, .q_pa = q, .p_eff_pa = p_eff},
          .evidence = "found",
          .noticed = Moment{reading + 2, std::nullopt}};
}

State state(std::int64_t reading, double q, double p_eff) {
  State s;
  s.reading = reading;
  s.q = q;
  s.p_eff = p_eff;
  s.strain = {0, 0};
  return s;
}

BackboneFall backbone(bool confirmed) {
  BackboneFall fall;
  fall.before_peak = state(6, 95e3, 152e3);
  fall.peak = fall.last_high = state(7, 100e3, 150e3);
  fall.first_low = state(8, 20e3, 60e3);
  fall.least = state(9, 10e3, 40e3);
  fall.first_low.strain = fall.least.strain = {0.02, -0.01};
  fall.regained = 10e3;
  fall.readings = 1;
  fall.confirmed = confirmed;
  fall.noticed = Moment{9, std::nullopt};
  return fall;
}

/// A runaway from 100 kPa to 5 kPa, of which `back` returns within ten readings.
LossAndReturn loss(double back) {
  LossAndReturn l(state(20, 100e3, 150e3), 0.05, Drainage::closed);
  for (int i = 21; i < 24; ++i) l.add(state(i, 5e3, 20e3));
  for (int i = 1; i <= 10; ++i) l.add(state(23 + i, 5e3 + back * i / 10, 20e3));
  return l;
}

/// Undrained cycles of ±40 kPa at p' = 100 kPa, the last of them with u near the cell pressure.
CycleCounter cycles(bool liquefies) {
  CycleCounter counter(false);
  std::int64_t reading = 1;
  for (int i = 0; i < 14; ++i) {
    const bool liquid = liquefies && i >= 10;
    for (const double q : {0.0, 40e3, 0.0, -40e3}) {
      State s = state(reading++, q, liquid ? 2e3 : 100e3);
      s.effective_stress = {s.p_eff + 2 * q / 3, s.p_eff - q / 3};
      s.strain = {0, 0};
      s.pore_pressure = liquid ? 298e3 : 200e3;
      counter.add(s);
    }
  }
  return counter;
}

std::string words(const std::optional<Instant>& at) {
  return at ? std::to_string(at->reading) : "-";
}

/// All that a rule may change.
std::string summary(std::span<const AssessmentRule> rules, const Evidence& e) {
  std::vector<Criterion> criteria;
  for (const CriterionRow& row : collapse_criteria())
    criteria.push_back(criterion_of(row, std::nullopt));
  criteria[0].detected = e.worst || e.at_held_q;
  const Collapse c = assess_by(rules, e, std::move(criteria));
  std::string text(to_string(c.kind));
  if (!c.judged) text += ", not assessed";
  if (c.judged_until) text += fmt::format(", until {}", *c.judged_until);
  text += ", onset " + words(c.onset);
  if (c.onset_detected_at) text += fmt::format(" known at {}", c.onset_detected_at->reading);
  text += ", loss of control " + words(c.loss_of_control);
  if (c.strength_lost) text += fmt::format(", lost {:.2f}", *c.strength_lost);
  if (c.second_order_work_normalised)
    text += fmt::format(", work {:.2f}", *c.second_order_work_normalised);
  if (c.inside_limit_surface) text += *c.inside_limit_surface ? ", inside" : ", on the limit";
  return text;
}

struct Case {
  Evidence needs;
  std::string result;
  Evidence contradicts;
  std::string other;
};

const std::map<std::string_view, std::function<Case()>>& cases() {
  static const LossAndReturn lost_for_good = loss(0), returned = loss(80e3);
  static const CycleCounter liquefied = cycles(true), calm = cycles(false);
  const auto& s = sand();
  const auto& u = unknown_limit();
  const auto soft = descent(100e3, 150e3, 95e3, 6e3);
  const auto little = descent(100e3, 150e3, 4e3, 96e3);
  const auto half = descent(60e3, 105e3, 9e3, 51e3);
  const auto held = at_constant_q(descent(60e3, 105e3, 0, 60e3));
  const auto runaway = finding(20, 100e3, 150e3);
  static const std::map<std::string_view, std::function<Case()>> all{
      {"too few readings",
       [&] {
         return Case{{.states = 5, .limit = s},
                     "none, not assessed, onset -, loss of control -",
                     {.states = 9, .points = 1, .limit = s},
                     "none, onset -, loss of control -"};
       }},
      {"softening",
       [=, &s] {
         return Case{{.worst = soft, .points = 50, .limit = s},
                     "flow, onset 10 known at 15, loss of control -, lost 0.95, work -0.20, inside",
                     {.worst = little, .points = 50, .limit = s},
                     "none, onset -, loss of control -"};
       }},
      {"yielding at constant q",
       [=, &s] {
         return Case{{.worst = half, .at_held_q = held, .points = 50, .limit = s},
                     "flow, onset 10 known at 15, loss of control -, lost 0.00, work -0.20, inside",
                     {.at_held_q = held, .points = 50, .limit = s},
                     "none, onset -, loss of control -"};
       }},
      {"drained peak",
       [=, &u] {
         return Case{{.worst = drained(little), .points = 50, .limit = u},
                     "none, onset 10, loss of control -, lost 0.04, work -0.20",
                     {.worst = little, .points = 50, .limit = u},
                     "none, onset -, loss of control -"};
       }},
      {"runaway",
       [=, &s] {
         return Case{
             {.loss_of_control = runaway, .points = 50, .limit = s},
             "flow, onset 20 known at 22, loss of control 20, inside",
             {.worst = soft, .loss_of_control = runaway, .points = 50, .limit = s},
             "flow, onset 10 known at 15, loss of control 20, lost 0.95, work -0.20, inside"};
       }},
      {"runaway after softening",
       [=, &s] {
         return Case{
             {.worst = half,
              .loss_of_control = runaway,
              .loss = &lost_for_good,
              .points = 50,
              .limit = s},
             "flow, onset 10 known at 15, loss of control 20, lost 0.92, work -0.20, inside",
             {.worst = half,
              .loss_of_control = runaway,
              .loss = &returned,
              .points = 50,
              .limit = s},
             "partial, onset 10 known at 15, loss of control 20, lost 0.15, work -0.20, inside"};
       }},
      {"loss between readings",
       [=, &s] {
         return Case{{.backbone = backbone(true), .limit = s},
                     "flow, onset 7 known at 9, loss of control -, lost 0.90, work 0.00, inside",
                     {.backbone = backbone(true), .cycles = &calm, .limit = s},
                     "none, not assessed, onset -, loss of control -"};
       }},
      {"loss in a single reading",
       [=, &s] {
         return Case{
             {.backbone = backbone(false), .limit = s},
             "none, not assessed, until 7, onset -, loss of control -",
             {.worst = soft, .points = 50, .backbone = backbone(false), .limit = s},
             "flow, onset 10 known at 15, loss of control -, lost 0.95, work -0.20, inside"};
       }},
      {"loss before the first window",
       [=, &s] {
         Descent late = descent(60e3, 105e3, 50e3, 10e3);
         return Case{
             {.worst = late, .points = 50, .backbone = backbone(true), .limit = s},
             "flow, onset 7 known at 15, loss of control -, lost 0.83, work -0.20, inside",
             {.worst = soft, .points = 50, .backbone = backbone(true), .limit = s},
             "flow, onset 10 known at 15, loss of control -, lost 0.95, work -0.20, inside"};
       }},
      {"fall",
       [=, &s] {
         const Instant fall{.reading = 90, .q_pa = 60e3, .p_eff_pa = 100e3};
         return Case{{.worst = soft, .fall = fall, .points = 50, .limit = s},
                     "flow, onset 90 known at 15, loss of control -, lost 0.95, work -0.20, inside",
                     {.fall = fall, .points = 50, .limit = s},
                     "none, onset -, loss of control -"};
       }},
      {"negative work before the runaway",
       [=, &s] {
         Descent frame = little;
         frame.by_displacement = true;
         const auto low = finding(20, 90e3, 140e3);
         return Case{{.worst = frame, .loss_of_control = low, .points = 50, .limit = s},
                     "flow, onset 10 known at 15, loss of control 20, inside",
                     {.worst = little, .loss_of_control = low, .points = 50, .limit = s},
                     "flow, onset 20 known at 15, loss of control 20, inside"};
       }},
      {"work of the fall",
       [=, &s] {
         const FallWork work{.normalised = -0.4, .error = 0.1, .evidence = "fell"};
         return Case{
             {.loss_of_control = runaway, .fall_work = work, .points = 50, .limit = s},
             "flow, onset 20 known at 22, loss of control 20, work -0.40, inside",
             {.worst = soft, .fall_work = work, .points = 50, .limit = s},
             "flow, onset 10 known at 15, loss of control -, lost 0.95, work -0.20, inside"};
       }},
      {"turn of the pore pressure",
       [=, &s] {
         const auto turn = finding(4, 60e3, 105e3);
         return Case{
             {.worst = soft,
              .control_peak = turn,
              .volume_by_pore_pressure = true,
              .points = 50,
              .limit = s},
             "flow, onset 4 known at 15, loss of control -, lost 0.95, work -0.20, inside",
             {.worst = soft, .control_peak = turn, .points = 50, .limit = s},
             "flow, onset 10 known at 15, loss of control -, lost 0.95, work -0.20, inside"};
       }},
      {"limit surface",
       [=, &s] {
         return Case{{.worst = soft, .points = 50, .limit = s},
                     "flow, onset 10 known at 15, loss of control -, lost 0.95, work -0.20, inside",
                     {.worst = little, .points = 50, .limit = s},
                     "none, onset -, loss of control -"};
       }},
      {"failure on the limit surface",
       [=, &s] {
         return Case{
             {.worst = descent(126e3, 100e3, 60e3, 66e3), .points = 50, .limit = s},
             "none, onset 10, loss of control -, lost 0.48, work -0.20, on the limit",
             {.worst = descent(120e3, 100e3, 60e3, 66e3), .points = 50, .limit = s},
             "flow, onset 10 known at 15, loss of control -, lost 0.50, work -0.20, inside"};
       }},
      {"failure past a drained peak",
       [=, &s, &u] {
         const auto peak = drained(descent(100e3, 120e3, 16e3, 84e3));
         return Case{
             {.worst = peak, .points = 50, .limit = u},
             "none, onset 10, loss of control -, lost 0.16, work -0.20",
             {.worst = peak, .points = 50, .limit = s},
             "partial, onset 10 known at 15, loss of control -, lost 0.16, work -0.20, inside"};
       }},
      {"unknown cohesion",
       [=, &u] {
         return Case{{.worst = descent(220e3, 100e3, 40e3, 180e3), .points = 50, .limit = u},
                     "none, not assessed, until 10, onset -, loss of control -",
                     {.worst = descent(120e3, 100e3, 40e3, 80e3), .points = 50, .limit = u},
                     "partial, onset 10 known at 15, loss of control -, lost 0.33, work -0.20"};
       }},
      {"time of detection",
       [=, &s] {
         return Case{{.worst = soft, .points = 50, .limit = s},
                     "flow, onset 10 known at 15, loss of control -, lost 0.95, work -0.20, inside",
                     {.worst = little, .points = 50, .limit = s},
                     "none, onset -, loss of control -"};
       }},
      {"loss of control",
       [=, &s] {
         return Case{
             {.worst = soft, .loss_of_control = runaway, .points = 50, .limit = s},
             "flow, onset 10 known at 15, loss of control 20, lost 0.95, work -0.20, inside",
             {.worst = soft, .points = 50, .limit = s},
             "flow, onset 10 known at 15, loss of control -, lost 0.95, work -0.20, inside"};
       }},
      {"zero stress",
       [=, &s] {
         const auto gone = finding(95, 0, 1e3);
         return Case{
             {.worst = soft, .zero_stress = gone, .points = 50, .limit = s},
             "flow, onset 10 known at 15, loss of control 95, lost 0.95, work -0.20, inside",
             {.worst = soft,
              .loss_of_control = runaway,
              .zero_stress = gone,
              .points = 50,
              .limit = s},
             "flow, onset 10 known at 15, loss of control 20, lost 0.95, work -0.20, inside"};
       }},
      {"zero stress without an onset",
       [=, &s] {
         const auto gone = finding(95, 0, 1e3);
         return Case{
             {.zero_stress = gone, .points = 50, .limit = s},
             "none, not assessed, until 95, onset -, loss of control 95",
             {.worst = soft, .zero_stress = gone, .points = 50, .limit = s},
             "flow, onset 10 known at 15, loss of control 95, lost 0.95, work -0.20, inside"};
       }},
      {"cyclic mobility",
       [=, &s] {
         return Case{{.points = 50, .cycles = &liquefied, .limit = s},
                     "cyclic_mobility, onset 41 known at 41, loss of control -",
                     {.points = 50, .cycles = &calm, .limit = s},
                     "none, onset -, loss of control -"};
       }},
      {"end past the onset",
       [=, &s] {
         Descent cut = descent(100e3, 150e3, 100, 99.9e3), over = cut;
         over.ended = true;
         return Case{{.worst = cut, .latest = cut, .points = 50, .limit = s},
                     "none, not assessed, until 10, onset -, loss of control -",
                     {.worst = over, .latest = over, .points = 50, .limit = s},
                     "none, onset -, loss of control -"};
       }},
      {"negative work at the end",
       [=, &s] {
         const Instant last{.reading = 40, .q_pa = 60e3, .p_eff_pa = 100e3};
         const Instant on_limit{.reading = 40, .q_pa = 127e3, .p_eff_pa = 100e3};
         return Case{{.negative_at_end = last, .points = 50, .limit = s},
                     "none, not assessed, until 40, onset -, loss of control -",
                     {.negative_at_end = on_limit, .points = 50, .limit = s},
                     "none, onset -, loss of control -"};
       }},
      {"loss at a constant strain",
       [=, &s] {
         const AxisRest::Fall rest{.reading = 8, .share = 0.6, .q = 100e3};
         return Case{
             {.worst = soft, .points = 50, .fall_at_rest = rest, .limit = s},
             "none, not assessed, until 8, onset -, loss of control -",
             {.worst = soft,
              .loss_of_control = runaway,
              .points = 50,
              .fall_at_rest = rest,
              .limit = s},
             "flow, onset 10 known at 15, loss of control 20, lost 0.95, work -0.20, inside"};
       }},
  };
  return all;
}

std::vector<AssessmentRule> without(std::string_view name) {
  std::vector<AssessmentRule> rest;
  for (const AssessmentRule& rule : assessment_rules())
    if (rule.name != name) rest.push_back(rule);
  return rest;
}

}  // namespace

TEST_CASE("AssessmentRule: one case needs each row, one contradicts it") {
  for (const AssessmentRule& rule : assessment_rules()) {
    INFO(rule.name);
    const auto found = cases().find(rule.name);
    REQUIRE(found != cases().end());
    const Case one = found->second();
    const auto rest = without(rule.name);
    CHECK(summary(assessment_rules(), one.needs) == one.result);
    CHECK(summary(rest, one.needs) != one.result);
    CHECK(summary(assessment_rules(), one.contradicts) == one.other);
    CHECK(summary(rest, one.contradicts) == one.other);
  }
  CHECK(cases().size() == assessment_rules().size());
}

}  // namespace rule_cases
