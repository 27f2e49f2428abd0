// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/specimen/implicit_step.hpp"

namespace triax::sim {

/// Motion of the cap with mass, m a = F_a − F − c v, by the velocity form of Verlet's method:
///
///   v_½ = v + a h/2,  x′ = x + v_½ h,  F′ from the specimen under this displacement, water
///   implicit, v′ = v_½ + a′ h/2   (c v′ implicit)
///
/// Substeps h are a share of √(m/|k|), k the stiffness in the direction of the motion. One at whose
/// end the stiffness is such that it was much too long (the motion has turned, or came from a limit
/// point, where k = 0) is repeated shorter.
///
/// The motion is over at the stop, which takes the kinetic energy, or when the cap comes to rest in
/// an equilibrium: the load is sustained again (ImplicitStep::sustains), |F_a − F| is below
/// kRestForce of the force of p′ (or of F), and the energy of what vibration is left,
/// E_c + (F_a − F)²/(2k), is below kRestShare of the largest kinetic energy of this run-away or,
/// once the motion has turned, below what changes F by kRestForce of the force of p′.
class InertialMotion : DrivenSpecimen {
 public:
  static constexpr double kRestShare = 1e-3;
  static constexpr double kRestForce = 0.02;

  /// Pre-condition: the axis is driven by a force and has a mass.
  using DrivenSpecimen::DrivenSpecimen;

  /// Opens a record of a run-away at this state, with its velocity.
  void begin(SpecimenState& state, double elapsed_s) const;

  /// Moves `whole` on from whole.done_s until dt_s or until the motion is over
  /// (state.run_away.under_way tells). Where the law ends, `whole` says so.
  void run(SpecimenStep& whole, double dt_s) const;

 private:
  double pull(const SpecimenState& state, double elapsed_s) const;
  double stiffness(const SpecimenState& state, double pull_n) const;
  double longest_substep(const SpecimenState& state, double pull_n, double stiffness) const;
  SpecimenStep substep(const SpecimenState& state, double elapsed_s, double h) const;
  void record(const SpecimenState& before, double elapsed_s, SpecimenStep& step) const;
  void compare(SpecimenState& state) const;
  double untold_force(const SpecimenState& state) const;
  bool at_rest(const SpecimenState& state, double pull_n) const;
  void stop(SpecimenStep& whole) const;

  ImplicitStep implicit_{*this};
};

}  // namespace triax::sim
