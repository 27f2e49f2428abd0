// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/point/self_driven.hpp"
#include "sim/specimen/specimen.hpp"

namespace triax::sim {

/// A specimen through one step of its boundary: what every way of moving it on has at hand. All
/// that is given has to live as long.
class DrivenSpecimen {
 public:
  /// `height_at_start_m` is that at the start of the boundary's step, from which the drive's spring
  /// counts.
  DrivenSpecimen(const Specimen& specimen, const SpecimenBoundary& boundary,
                 const SpecimenTolerance& tolerance, double height_at_start_m)
      : specimen_(specimen),
        boundary_(boundary),
        tolerance_(tolerance),
        height_at_start_m_(height_at_start_m),
        self_driven_(specimen.law().self_driven()) {}

 protected:
  const Specimen& specimen_;
  const SpecimenBoundary& boundary_;
  const SpecimenTolerance& tolerance_;
  double height_at_start_m_;
  const SelfDriven<Axisymmetric>* self_driven_;  ///< the law, if it is one
};

/// One implicit step of a specimen under a boundary: the conditions of axis and water hold at its
/// end. They are linear in the increments of σ′ and ε but for the change of height, area and volume
/// and for water and air; these are found by Newton's method around the whole increment, which the
/// point driver integrates as one path each time: to round-off, or as closely as a self-driven law
/// can. What is missed is made up for by the next step, as the conditions are on totals.
class ImplicitStep : DrivenSpecimen {
 public:
  using DrivenSpecimen::DrivenSpecimen;
  explicit ImplicitStep(const DrivenSpecimen& driven) : DrivenSpecimen(driven) {}

  /// From `elapsed_s` after the start of the boundary's step over `dt_s`. Lost control and failure
  /// leave the state where they came; no work is told.
  SpecimenStep take(const SpecimenState& state, double elapsed_s, double dt_s) const;

  /// dF/dx (N/m) under this boundary's water at this instant, without flow through a resistance;
  /// `direction` is +1 for compression, −1 for extension. NaN where no rate exists.
  double stiffness(const SpecimenState& state, double direction) const;

  /// Whether a small change of force, of either sign, finds a rate at this instant, without flow
  /// through a resistance: the equilibrium can be sustained.
  bool sustains(const SpecimenState& state) const;

  /// F_a at an instant of the boundary's step.
  double applied_force(const SpecimenState& state, double elapsed_s) const;

 private:
  struct Increment {
    double q = 0, radial = 0;      // Δq, Δσ₃′
    double axial = 0, volume = 0;  // Δε₁, Δε_v
  };
  struct Instant;  // what the conditions are asked of
  struct Conditions;

  Instant instant(const SpecimenState& start, const Increment& moved, double cell) const;
  DrivingTolerance allowed(const SpecimenState& start) const;
  Conditions conditions(const SpecimenState& start, double elapsed_s, double dt_s,
                        const Increment& about) const;
  void move_cap(const SpecimenState& start, double dt_s, Conditions& found) const;
  void balance_force(const SpecimenState& start, const Instant& at, double end_s,
                     const Increment& about, Conditions& found) const;
  void balance_water(const SpecimenState& start, const Instant& at, double elapsed_s, double dt_s,
                     const Increment& about, Conditions& found) const;
  Increment predict(const SpecimenState& start, const Conditions& conditions) const;
  SpecimenStep integrate(const SpecimenState& start, const Conditions& conditions,
                         double dt_s) const;
  void settle_water(const SpecimenState& start, SpecimenStep& step) const;
};

}  // namespace triax::sim
