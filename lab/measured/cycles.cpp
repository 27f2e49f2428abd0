// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/cycles.hpp"

#include <algorithm>
#include <cmath>

#include "lab/measured/assessment_limits.hpp"
#include "lab/measured/instant.hpp"

namespace triax::lab {

namespace limits = assessment_limits;
void CycleCounter::Range::add(double value) {
  low = std::min(low, value);
  high = std::max(high, value);
}

void CycleCounter::add(const State& state) {
  if (!first_) {
    first_ = extreme_ = state;
    strain_ = strain_since_ = {state.strain.axial, state.strain.axial};
    strain_extreme_ = state.strain.axial;
  }
  noise_.add(state.q);
  if (is_within_the_cycles(state.q)) strain_since_.add(state.strain.axial);
  follow(state);
  follow_strain(state.strain.axial);
  watch_pore_pressure(state);
  watch_strain(state);
}

void CycleCounter::follow(const State& state) {
  const double least = std::max(kLeast * std::fabs(first_->p_eff), limits::kNoise * noise_.value());
  if (direction_ == 0) {
    const double moved = state.q - first_->q;
    if (std::fabs(moved) > least) direction_ = moved > 0 ? 1 : -1;
    reach(state);
    return;
  }
  const double back = direction_ * (extreme_.q - state.q);
  if (back <= 0) reach(state);
  if (back > least) turn(state);
}

void CycleCounter::follow_strain(double strain) {
  strain_noise_.add(strain);
  const double least = std::max(kMinStrain, limits::kNoise * strain_noise_.value());
  const double moved = strain - strain_extreme_;
  if (strain_direction_ == 0) {
    if (std::fabs(moved) < least) return;
    strain_direction_ = moved > 0 ? 1 : -1;
  } else if (strain_direction_ * moved < -least) {
    strain_direction_ = -strain_direction_;
    ++strain_turns_;
  } else if (strain_direction_ * moved <= 0) {
    return;
  }
  strain_extreme_ = strain;
}

/// Whether q lies between the last two turns, with a tenth to spare: shear beyond them is no
/// cycle's.
bool CycleCounter::is_within_the_cycles(double q) const {
  constexpr double kSpare = 0.1;
  if (recent_.size() < 2) return true;
  const auto [low, high] = std::minmax(recent_.back().q, recent_[recent_.size() - 2].q);
  const double spare = kSpare * (high - low);
  return q >= low - spare && q <= high + spare;
}

/// The half cycle goes on: what was strained since its last extreme belongs to it.
void CycleCounter::reach(const State& state) {
  extreme_ = state;
  strain_.add(strain_since_.low);
  strain_.add(strain_since_.high);
  if (is_within_the_cycles(state.q))
    strain_since_ = {state.strain.axial, state.strain.axial};
  else
    strain_since_ = strain_;
}

void CycleCounter::turn(const State& state) {
  ++turns_;
  (direction_ > 0 ? high_ : low_).add(extreme_.q);
  recent_.push_back({extreme_.reading, extreme_.q});
  if (recent_.size() > kTurns) recent_.pop_front();
  strain_ = strain_since_ = {extreme_.strain.axial, extreme_.strain.axial};
  direction_ = -direction_;
  reach(state);
}

CycleInstant CycleCounter::at(const State& state) const {
  return {.instant = instant_of(state, has_time_), .cycle = cycle_of(state)};
}

/// Loggers count from 0, in fractions, or from 1: either way the first row is in the first cycle.
int CycleCounter::cycle_of(const State& state) const {
  constexpr double kRounding = 1e-6;
  const double counted = std::floor(state.cycle - first_->cycle + kRounding) + 1;
  return counted >= 1 && counted < 1e9 ? static_cast<int>(counted) : turns() / 2 + 1;
}

/// r_u from the pore pressure, or, where the cell pressure stands, from the effective radial
/// stress.
void CycleCounter::watch_pore_pressure(const State& state) {
  const double by_water = state.pore_pressure - first_->pore_pressure;
  const double by_stress = first_->effective_stress.radial - state.effective_stress.radial;
  const double ratio =
      (std::isfinite(by_water) ? by_water : by_stress) / first_->effective_stress.radial;
  if (!(ratio > found_.largest_pore_pressure_ratio)) return;
  found_.largest_pore_pressure_ratio = ratio;
  if (ratio >= limits::kLiquefied && !found_.liquefied) found_.liquefied = at(state);
}

void CycleCounter::watch_strain(const State& state) {
  Range half = strain_;
  half.add(strain_since_.low);
  half.add(strain_since_.high);
  const double amplitude = half.size();
  if (turns_ < 2 || !(amplitude > found_.largest_double_amplitude)) return;
  found_.largest_double_amplitude = amplitude;
  if (amplitude >= limits::kDoubleAmplitude && !found_.double_amplitude)
    found_.double_amplitude = at(state);
}

std::optional<CyclicLoading> CycleCounter::loading() const {
  if (turns() < kFewest) return std::nullopt;
  return CyclicLoading{.cycles = turns() / 2.0,
                       .q_low_pa = low_.value,
                       .q_high_pa = high_.value,
                       .stress_ratio = (high_.value - low_.value) / 4 / first_->p_eff,
                       .largest_pore_pressure_ratio = found_.largest_pore_pressure_ratio,
                       .largest_double_amplitude = found_.largest_double_amplitude,
                       .liquefied = found_.liquefied,
                       .double_amplitude = by_strain() ? std::nullopt : found_.double_amplitude};
}

bool CycleCounter::carried_on(std::int64_t reading, double q) const {
  constexpr double kMost = 0.9;
  const auto first =
      std::ranges::find_if(recent_, [&](const Turn& t) { return t.reading > reading; });
  return first != recent_.end() && std::any_of(first + 1, recent_.end(), [&](const Turn& turn) {
           return std::copysign(1.0, q) * turn.q >= kMost * std::fabs(q);
         });
}

}  // namespace triax::lab
