// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/pore_fluid.hpp"

#include <algorithm>
#include <cmath>

namespace triax::lab {
namespace {

constexpr double kAtmosphere = 101.325e3;  ///< Pa
constexpr double kLeastStep = 5e3;         ///< Pa of u in a B check
constexpr double kLeastOfEach = 3;         ///< readings of each
constexpr double kNearCheck = 2;           ///< p′ over that of the B check: its skeleton
constexpr double kLeastSpread = 100;       ///< Pa, of √p′ + s/P, squared: what tells a slope

}  // namespace

void PoreFluid::Line::add(double at, double value) {
  n += 1, x += at, y += value, xx += at * at, xy += at * value;
}

void PoreFluid::start_stage(const State& state) {
  stage_ = state.stage;
  drained_before_ = drained_;  // strains start anew with each stage before shear
}

void PoreFluid::add(const State& state, const StageInfo* stage) {
  if (!stage || !(state.p_eff > 0) || !std::isfinite(state.pore_pressure)) return;
  const bool begins = stage_ != state.stage;
  if (begins) start_stage(state);
  const double root = std::sqrt(state.p_eff);
  if (stage->role == StageRole::b_check) {
    const double cell = state.effective_stress.radial + state.pore_pressure;
    if (begins) b_check_ = {}, checked_from_ = state.pore_pressure, cell_from_ = cell;
    checked_ = state.pore_pressure;
    cell_ = cell;
    checked_p_ = begins ? state.p_eff : std::max(checked_p_, state.p_eff);
    b_check_.add(-1 / (state.pore_pressure + kAtmosphere), root);
  }
  if (stage->role != StageRole::consolidation || stage->drainage != Drainage::open) return;
  drained_ = drained_before_ + state.volumetric_strain;
  const bool is_near = !(checked_p_ > 0) || state.p_eff <= kNearCheck * checked_p_;
  if (!is_near && consolidation_.variance() > kLeastSpread) return;
  // What flows out is what the skeleton gives and what the fluid swells by as u falls: k√p′ + a/P.
  const double swells = b_check_.n < kLeastOfEach ? 0 : b_check_.slope();
  consolidation_.add(root + swells / (state.pore_pressure + kAtmosphere), drained_);
}

double PoreFluid::a() const {
  if (std::fabs(checked_ - checked_from_) < kLeastStep) return 0;
  if (b_check_.n < kLeastOfEach || consolidation_.n < kLeastOfEach) return 0;
  const double a = b_check_.slope() * consolidation_.slope();
  return std::isfinite(a) ? std::max(a, 0.0) : 0;
}

std::optional<double> PoreFluid::give() const {
  const double u = checked_ - checked_from_, cell = cell_ - cell_from_;
  if (!(std::fabs(u) >= kLeastStep) || !std::isfinite(cell)) return std::nullopt;
  return std::max(cell / u - 1, 0.0);
}

double PoreFluid::compliance(double u_pa) const {
  const double p = u_pa + kAtmosphere;
  return p > 0 ? a() / (p * p) : 0;
}

double PoreFluid::strain(double u_pa) const {
  const double p = u_pa + kAtmosphere;
  return p > 0 ? -a() / p : 0;
}

}  // namespace triax::lab
