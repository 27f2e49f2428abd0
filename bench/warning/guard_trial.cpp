// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/warning/guard_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/warning/alarm_trial.hpp"
#include "lab/measured/path_sampler.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

namespace triax::bench {
namespace {

/// A run-away that was no slip.
const lab::RunAwayTruth* fall_in(const lab::Truth& truth, double after_s) {
  const lab::RunAwayTruth* fall = nullptr;
  for (const auto& one : truth.run_aways)
    if (one.start_s >= after_s && one.end != lab::RunAwayEnd::new_equilibrium) fall = &one;
  return fall;
}

void run_as_it_is(const lab::Programme& programme, GuardTrial& t) {
  lab::VirtualRig rig(programme, t.seed);
  std::vector<double> times;
  std::optional<double> known_s;
  lab::SessionListener listener;
  listener.scanned = [&](const lab::Reading& reading, const lab::State&) {
    times.push_back(reading.time_s);
  };
  listener.happened = [&](const lab::Event& event) {
    if (event.kind == lab::EventKind::lost && !known_s) known_s = times.back();
  };
  std::vector<lab::Forecast> forecasts;
  listener.foreseen = [&](const lab::Forecast& one) { forecasts.push_back(one); };
  const lab::TestSummary summary = lab::run_session(rig, {}, {listener});
  const lab::Truth& truth = *summary.truth;
  t.earlier = as_recorded(rig.header(), summary, forecasts);
  t.lost = truth.lost_sustainability;
  t.said_lost = known_s.has_value();
  if (const auto* fall = fall_in(truth, 0)) t.fall_s = fall->start_s;
  if (t.fall_s) t.shown = times.end() - std::ranges::lower_bound(times, *t.fall_s) >= 3;
  if (t.fall_s && known_s)
    t.known_after = static_cast<int>(std::ranges::upper_bound(times, *known_s) -
                                     std::ranges::lower_bound(times, *t.fall_s));
}

double share(std::ptrdiff_t part, std::size_t whole) {
  return whole ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : NAN;
}

using Some = std::vector<const GuardTrial*>;

void print_catches(const std::string& name, const Some& all) {
  if (all.empty()) return;
  Some in_time;
  std::ranges::copy_if(all, std::back_inserter(in_time), &GuardTrial::in_time);
  const auto caught = std::ranges::count_if(in_time, &GuardTrial::caught);
  double most = 0;
  for (const auto* t : in_time) most = std::max(most, t->further_strain);
  int known = 0, falls = 0, latest = 0;
  for (const auto* t : all) {
    if (!t->shown) continue;
    ++falls;
    known += t->known_after && *t->known_after <= 3;
    latest = std::max(latest, t->known_after.value_or(0));
  }
  fmt::print("{:16} {:5} {:10.1f} {:10.1f} {:10.1f} {:12.2f} {:9} {:12.1f} {:7}\n", name,
             all.size(), share(std::ssize(in_time), all.size()), share(caught, in_time.size()),
             share(caught, all.size()), 100 * most, falls,
             share(known, static_cast<std::size_t>(falls)), latest);
}

std::string kind_of(const GuardTrial& t) { return t.type + (t.fall_s ? "" : ", no fall"); }

}  // namespace

void run_guarded(const Subject& subject, const lab::EarlierTests& earlier, GuardTrial& t) {
  Instruments instruments{};
  lab::Programme programme = varied_for_alarm(subject, t.seed, instruments);
  programme.guard =
      lab::Guard{.rate_m_per_s = GuardTrial::kRate_m_per_s, .further_strain = GuardTrial::kAsked};
  lab::VirtualRig rig(programme, t.seed);
  const lab::TestSummary summary = lab::run_session(rig, {.earlier = earlier});
  t.acted_s.reset();
  t.further_strain = 0;
  t.ran_away = false;
  if (!summary.guard) return;
  const lab::GuardOutcome& guard = *summary.guard;
  t.acted_s = guard.at.time_s;
  t.further_strain = std::fabs(*guard.last_axial_strain - *guard.at.axial_strain);
  t.ran_away = fall_in(*summary.truth, *t.acted_s) != nullptr;
}

GuardTrial run_guard_trial(const Subject& subject, std::uint64_t seed) {
  Instruments instruments{};
  const lab::Programme programme = varied_for_alarm(subject, seed, instruments);
  GuardTrial t;
  t.fill(programme, subject.collapses, seed);
  for (const lab::Stage& stage : programme.stages)
    if (stage.role == lab::StageRole::shear) t.under_force = lab::guards({}, stage);
  run_as_it_is(programme, t);
  run_guarded(subject, {}, t);
  return t;
}

void print_guard_trials(const std::string& title, const std::vector<GuardTrial>& trials,
                        bool failures) {
  fmt::print("\n{}\n", title);
  std::vector<std::string> kinds;
  Some falls, controls;
  for (const auto& t : trials) {
    if (t.programme.empty() || !t.comparable()) continue;
    if (!t.collapses) controls.push_back(&t);
    if (!t.collapses || !t.under_force) continue;
    falls.push_back(&t);
    if (std::ranges::find(kinds, kind_of(t)) == kinds.end()) kinds.push_back(kind_of(t));
  }
  fmt::print("{:16} {:>5} {:>10} {:>10} {:>10} {:>12} {:>9} {:>12} {:>7}\n", "by force", "tests",
             "in time %", "of these", "of all", "most further", "falls", "lost within", "latest");
  fmt::print("{:16} {:>5} {:>10} {:>10} {:>10} {:>12} {:>9} {:>12} {:>7}\n", "", "", "", "caught %",
             "caught %", "strain %", "", "3 readings %", "");
  for (const std::string& kind : kinds) {
    Some some;
    std::ranges::copy_if(falls, std::back_inserter(some),
                         [&](const auto* t) { return kind_of(*t) == kind; });
    print_catches(kind, some);
  }
  print_catches("all", falls);
  const auto acted = [](const GuardTrial* t) { return t->acted_s.has_value(); };
  const auto said = [](const GuardTrial* t) { return t->said_lost; };
  fmt::print("\n{} controls: {:.2f} % caught falsely, {:.2f} % reported as lost\n", controls.size(),
             share(std::ranges::count_if(controls, acted), controls.size()),
             share(std::ranges::count_if(controls, said), controls.size()));
  if (!failures) return;
  for (const auto* t : falls)
    if (!t->caught() || (t->shown && !(t->known_after && *t->known_after <= 3)))
      fmt::print(
          "{} {} seed {}: fall {:.0f} s, lost after {} readings; guard {:.0f} s, further "
          "strain {:.2f} %{}\n",
          t->programme, t->material, t->seed, t->fall_s.value_or(NAN), t->known_after.value_or(-1),
          t->acted_s.value_or(NAN), 100 * t->further_strain, t->ran_away ? ", ran away" : "");
  for (const auto* t : controls)
    if (acted(t) || said(t))
      fmt::print("control {} {} seed {}: guard {:.0f} s{}\n", t->programme, t->material, t->seed,
                 t->acted_s.value_or(NAN), t->said_lost ? ", reported as lost" : "");
}

}  // namespace triax::bench
