// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/guard_stages.hpp"

#include <fmt/format.h>

#include <cmath>

namespace triax::lab {
namespace {

using Action = Guard::Action;

Stage successor_of(const Guard& guard, const Stage& stage) {
  const bool goes_on = guard.action == Action::hand_over;
  Stage next;
  next.name =
      fmt::format("guard: {} {}", goes_on ? "displacement after" : "unloading of", stage.name);
  next.role = goes_on ? StageRole::shear : StageRole::hold;
  next.valve_open = stage.valve_open;
  next.axial = AxialAction::displacement;
  next.axial_rate_m_per_s = guard.rate_m_per_s;
  next.logging = stage.logging;
  next.line = stage.line;
  return next;
}

}  // namespace

GuardedProgramme with_guard_stages(Programme programme) {
  GuardedProgramme all{std::move(programme), {}};
  std::vector<Stage>& stages = all.programme.stages;
  all.successor.resize(stages.size());
  if (!all.programme.guard) return all;
  const Guard& guard = *all.programme.guard;
  if (guard.action != Action::hand_over && guard.action != Action::unload) return all;
  for (std::size_t i = 0; i < all.successor.size(); ++i) {
    if (!guards(guard, stages[i])) continue;
    all.successor[i] = stages.size();
    stages.push_back(successor_of(guard, stages[i]));
  }
  return all;
}

void aim(const Guard& guard, const Seen& seen, double height_m, Stage& successor) {
  const State& now = seen.state();
  const double loaded = now.q < 0 ? -1 : 1;
  EndCondition end;
  double way_m = guard.further_strain * height_m;
  if (guard.action == Action::hand_over) {
    successor.axial_rate_m_per_s = loaded * guard.rate_m_per_s;
    end.quantity = EndQuantity::axial_strain;
    const double until = now.strain.axial + loaded * guard.further_strain;
    (loaded > 0 ? end.above : end.below) = until;
  } else {
    successor.axial_rate_m_per_s = -loaded * guard.rate_m_per_s;
    end.quantity = EndQuantity::deviator_stress;
    (loaded > 0 ? end.below : end.above) = (1 - guard.share) * now.q;
    way_m = 0.02 * height_m;  // what is elastic comes back long before
  }
  successor.end = {end};
  constexpr double kSlack_s = 3600;  // load cell and frame give way first
  successor.time_limit_s = 2 * way_m / guard.rate_m_per_s + kSlack_s;
}

std::string describe(const Guard& guard) {
  const double rate = guard.rate_m_per_s * 6e4;
  switch (guard.action) {
    case Action::hand_over:
      return fmt::format("switched to displacement at {:g} mm/min", rate);
    case Action::hold:
      return fmt::format("crosshead locked and pressures held for {:g} min", guard.hold_s / 60);
    case Action::unload:
      return fmt::format("switched to displacement, q reduced by {:g} % at {:g} mm/min",
                         guard.share * 100, rate);
    case Action::safe:
      return "safe state";
  }
  return {};
}

}  // namespace triax::lab
