// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/grain_ledger.hpp"

#include <algorithm>
#include <cmath>

#include "sim/grains/state/grain_measures.hpp"

namespace triax::sim {
namespace {

void add_momentum(const GrainState& state, double sign, std::array<double, 3>& sum) {
  for (const Grain& g : state.grains)
    for (int a = 0; a < 3; ++a) sum[a] += sign * g.velocity[a] / g.inverse_mass;
}

/// ½ Σ F · ΔX of the walls between two boxes: they push inwards.
double half_work(const GrainState& state, const GrainBox& from, const GrainBox& to) {
  double sum = 0;
  for (int a = 0; a < 3; ++a)
    sum += state.walls.force_n[2 * a] * (to.low_m[a] - from.low_m[a]) +
           state.walls.force_n[2 * a + 1] * (from.high_m[a] - to.high_m[a]);
  return 0.5 * sum;
}

}  // namespace

double GrainLedger::energy_error_j() const {
  return walls_j - (elastic_end_j - elastic_start_j) - (kinetic_end_j - kinetic_start_j) -
         friction_j - damping_j - stopped_j;
}

double GrainLedger::energy_error_share() const {
  const double elastic = elastic_end_j - elastic_start_j, kinetic = kinetic_end_j - kinetic_start_j;
  const auto both = [](double x) { return std::array{std::max(x, 0.0), std::max(-x, 0.0)}; };
  double out = 0, in = 0;
  for (const double part : {-walls_j, elastic, kinetic, friction_j, damping_j, stopped_j}) {
    out += both(part)[0];
    in += both(part)[1];
  }
  const double most = std::max({in, out, elastic_end_j, kinetic_end_j});
  const double error = std::abs(energy_error_j());
  return most > 0 ? error / most : error;
}

double GrainLedger::momentum_error() const {
  double most = 0;
  for (int a = 0; a < 3; ++a) {
    const double error = std::abs(walls_impulse[a] + damping_impulse[a] - stopped_impulse[a] -
                                  (momentum_end[a] - momentum_start[a]));
    if (!(error <= most)) most = error;
  }
  return most;
}

double elastic_energy(const GrainState& state) {
  const double ratio = state.law.tangential_ratio;
  double sum = 0;
  for (const GrainContact& c : contacts_of(state)) {
    const double radius = state.grains[c.i].radius;
    const double k = c.j < 0 ? wall_stiffness(state.law, radius)
                             : normal_stiffness(state.law, radius, state.grains[c.j].radius);
    sum += 0.5 * c.normal_force_n * c.normal_force_n / k;
    if (c.tangential_force_n > 0)
      sum += 0.5 * c.tangential_force_n * c.tangential_force_n / (ratio * k);
  }
  return sum;
}

void LedgerBook::before_walls(const GrainState& state, double friction_j) {
  if (open_) {
    ledger_.walls_j += walls_later_ + half_work(state, box_, state.box);
    ledger_.friction_j += friction_j;
    for (int a = 0; a < 3; ++a)
      ledger_.walls_impulse[a] +=
          (state.walls.force_n[2 * a] - state.walls.force_n[2 * a + 1]) * state.time_step_s;
  }
  box_ = state.box;
}

void LedgerBook::after_walls(const GrainState& state) {
  walls_later_ = half_work(state, box_, state.box);
}

void LedgerBook::end_step(const GrainState& state, const MotionTotals& sums) {
  for (int a = 0; a < 3; ++a) {
    if (open_) ledger_.damping_impulse[a] += sums.braked[a];
    ledger_.momentum_end[a] = sums.momentum[a];
  }
  if (open_) {
    ledger_.damping_j += damping_later_ + sums.damping_before;
  } else {
    ledger_.elastic_start_j = elastic_energy(state);
    ledger_.kinetic_start_j = sums.kinetic;
    ledger_.momentum_start = ledger_.momentum_end;
  }
  open_ = true;
  damping_later_ = sums.damping_after;
  ledger_.kinetic_end_j = sums.kinetic;
  elastic_before_change_.reset();
}

void LedgerBook::before_change(const GrainState& state) {
  if (!open_) return;
  if (!elastic_before_change_) elastic_before_change_ = elastic_energy(state);
  book_change(state, 1);
}

void LedgerBook::after_change(const GrainState& state) {
  if (open_) book_change(state, -1);
}

void LedgerBook::book_change(const GrainState& state, double sign) {
  const double energy = sign * kinetic_energy(state);
  ledger_.stopped_j += energy;
  ledger_.kinetic_end_j -= energy;
  add_momentum(state, sign, ledger_.stopped_impulse);
  add_momentum(state, -sign, ledger_.momentum_end);
}

std::optional<GrainLedger> LedgerBook::closed(const GrainState& state) const {
  if (!open_) return {};
  GrainLedger ledger = ledger_;
  ledger.elastic_end_j = elastic_before_change_ ? *elastic_before_change_ : elastic_energy(state);
  return ledger;
}

}  // namespace triax::sim
