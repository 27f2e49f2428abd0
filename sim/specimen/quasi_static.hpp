// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/specimen/implicit_step.hpp"

namespace triax::sim {

/// The specimen through a succession of equilibria. Flow through a resistance is integrated
/// implicitly in u with error-controlled substeps (with a self-driven law, which is moved once, in
/// one: to first order in the step over the time of drainage); a cap that a force drives ends at
/// its stop, which carries the rest until the drive pulls away.
class QuasiStatic : DrivenSpecimen {
 public:
  using DrivenSpecimen::DrivenSpecimen;

  /// Moves `whole` on from whole.done_s until dt_s, or to where its outcome tells.
  void run(SpecimenStep& whole, double dt_s) const;

 private:
  SpecimenStep part(const SpecimenState& state, double elapsed_s, double h) const;
  SpecimenStep driven(const ImplicitStep& by, const SpecimenState& state, double elapsed_s,
                      double h) const;
  SpecimenStep to_stop(const SpecimenState& state, double way, double elapsed_s, double h) const;
  bool require_sustained(SpecimenStep& whole) const;
  void run_through_resistance(SpecimenStep& whole, double dt_s) const;

  ImplicitStep implicit_{*this};
};

}  // namespace triax::sim
