// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/simulated/run_away_log.hpp"

#include <fmt/format.h>

#include <cmath>

namespace triax::lab {
namespace {

void copy_comparison(const sim::RunAway& from, RunAwayTruth& to) {
  to.largest_kinetic_energy_j = from.largest_kinetic_energy_j;
  if (from.compared_at_s == 0) return;
  to.kinetic_energy_j = -from.ratio() * from.second_order_work_j / 2;
  to.second_order_work_j = from.second_order_work_j;
  if (std::isfinite(from.expected_ratio())) to.expected_ratio = from.expected_ratio();
}

void copy_state(const Truth& from, RunAwayTruth& to) {
  to.axial_strain = from.axial_strain;
  to.q_pa = from.q_pa;
  to.p_eff_pa = from.p_eff_pa;
  to.pore_pressure_pa = from.pore_pressure_pa;
}

RunAwayEnd ending(sim::RunAway::End end) {
  switch (end) {
    case sim::RunAway::End::arrested:
      return RunAwayEnd::new_equilibrium;
    case sim::RunAway::End::end_of_travel:
      return RunAwayEnd::end_of_travel;
    case sim::RunAway::End::none:
      return RunAwayEnd::none;
  }
  return RunAwayEnd::none;
}

}  // namespace

std::string RunAwayLog::watch(double time_s, const sim::SpecimenState& state,
                              const std::optional<Truth>& start) {
  const sim::RunAway& now = state.run_away;
  const bool began = now.count != seen_;
  seen_ = now.count;
  if (began) {
    follows_ = all_.size() < kMost;
    if (follows_) all_.push_back({.start_s = time_s - now.elapsed_s});
    if (follows_ && start) copy_state(*start, all_.back());
    running_ = true;
  }
  if (!running_) return {};
  if (follows_) {
    RunAwayTruth& truth = all_.back();
    copy_comparison(now, truth);
    truth.largest_at_s = truth.start_s + now.largest_at_s;
  }
  const double start_s = time_s - now.elapsed_s;
  if (now.under_way)
    return began ? fmt::format("equilibrium lost at {:.4f} s: runaway of the cap", start_s) : "";
  running_ = false;
  if (follows_) {
    all_.back().end_s = all_.back().start_s + now.elapsed_s;
    all_.back().end = ending(now.end);
  }
  return fmt::format("runaway of the cap for {:.4f} s, kinetic energy up to {:.3g} J: {}",
                     now.elapsed_s, now.largest_kinetic_energy_j, to_string(ending(now.end)));
}

}  // namespace triax::lab
