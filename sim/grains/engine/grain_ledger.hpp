// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where the energy and the momentum of a specimen of grains went, booked step by step while the
// engine runs. With forces F_n at the positions x_n, velocities v_{n±1/2} on both sides of them and
// walls at X_n (grains.hpp):
//
//   walls      W = Σ F_n · (X_{n+1} − X_{n−1})/2         on the grains
//   friction   Σ ½ (F_t before + F_t after) · slip,      slip = (F_t tried − F_t after)/k_t; a
//              contact that opens with a tangential force slips until there is none
//   damping    Σ F_d · (v_{n−1/2} + v_{n+1/2})/2 Δt
//   elastic    Σ F_n²/2k_n + F_t²/2k_t                   at x_n, walls included
//   kinetic    Σ ½ m v_{n−1/2} · v_{n+1/2}               spins alike, at x_n
//
//   W = Δelastic + Δkinetic + friction + damping + stopped
//
// holds to round-off but for contacts that close, open or turn within a step. Momentum,
// with Σ of the walls' and the damping forces × Δt, holds to round-off: Δ Σ m v = walls + damping +
// stopped. `stopped` is what was taken out by stop_motion() and set_velocity().
#include <array>
#include <optional>

#include "sim/grains/engine/blocks.hpp"
#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

struct GrainLedger {
  double walls_j = 0, friction_j = 0, damping_j = 0, stopped_j = 0;
  double elastic_start_j = 0, elastic_end_j = 0;
  double kinetic_start_j = 0, kinetic_end_j = 0;
  /// Along the axes of the box, kg m/s.
  std::array<double, 3> walls_impulse{}, damping_impulse{}, stopped_impulse{};
  std::array<double, 3> momentum_start{}, momentum_end{};

  /// What is missing on the right hand side: 0 if nothing was lost.
  double energy_error_j() const;
  /// |error| over the largest of what went in, what came out and the energies at the end; 0 where
  /// there is none. What is not a number makes this and the next ones not a number.
  double energy_error_share() const;
  /// The largest component of what is missing, kg m/s.
  double momentum_error() const;
};

/// Σ F_n²/2k_n + F_t²/2k_t over all contacts, walls included, J; forces as contacts_of() has them.
double elastic_energy(const GrainState& state);

/// Keeps the book for an engine.
class LedgerBook {
 public:
  /// Of one step: forces and walls known, walls not moved yet.
  void before_walls(const GrainState& state, double friction_j);
  void after_walls(const GrainState& state);
  /// Of the same step: grains moved, neighbours still as they were. The first step opens the book.
  void end_step(const GrainState& state, const MotionTotals& sums);
  /// Velocities of `state` are about to be changed (before) or were (after) from outside.
  void before_change(const GrainState& state);
  void after_change(const GrainState& state);

  /// Empty until a step was made. `state` is the engine's.
  std::optional<GrainLedger> closed(const GrainState& state) const;

 private:
  void book_change(const GrainState& state, double sign);

  GrainLedger ledger_;
  bool open_ = false;
  GrainBox box_;                                ///< when forces were evaluated
  double walls_later_ = 0, damping_later_ = 0;  ///< second halves of the last step
  /// Forces stand where the last velocities lead back to: known before these are changed.
  std::optional<double> elastic_before_change_;
};

}  // namespace triax::sim
