// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/pore_fluid.hpp"

#include <algorithm>
#include <cmath>

namespace triax::lab {
namespace {

constexpr double kAtmosphere = 101.325e3;  ///< Pa
constexpr double kLeastStep = 5e3;         ///< Pa of u in a B check
constexpr double kLeastOfEach = 3;         ///< readings of each

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
    if (begins) b_check_ = {}, checked_from_ = state.pore_pressure;
    checked_ = state.pore_pressure;
    b_check_.add(-1 / (state.pore_pressure + kAtmosphere), root);
  }
  if (stage->role != StageRole::consolidation || stage->drainage != Drainage::open) return;
  drained_ = drained_before_ + state.volumetric_strain;
  consolidation_.add(root, drained_);
}

double PoreFluid::a() const {
  if (std::fabs(checked_ - checked_from_) < kLeastStep) return 0;
  if (b_check_.n < kLeastOfEach || consolidation_.n < kLeastOfEach) return 0;
  const double a = b_check_.slope() * consolidation_.slope();
  return std::isfinite(a) ? std::max(a, 0.0) : 0;
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
