// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/specimen/specimen.hpp"

namespace triax::sim {

/// Whether the step reached its end.
inline bool went_on(const SpecimenStep& step) {
  return step.outcome == StepOutcome::accepted || step.outcome == StepOutcome::inaccurate;
}

/// Ends the step as where the law goes no further once its integration has taken more steps than
/// the tolerance allows; false as long as it may go on.
bool exhausted(SpecimenStep& whole, const SpecimenTolerance& tolerance);

/// Work of one part of a step by trapezoid, with that of the axis as the specimen takes it, F dx.
/// `back_pressure_pa` is the mean of the part, without meaning where nothing drained.
StepWork work_between(const Specimen& specimen, const SpecimenState& before,
                      const SpecimenStep& step, double back_pressure_pa);

/// Puts the next part behind what was done.
void append(SpecimenStep& whole, const SpecimenStep& part);

}  // namespace triax::sim
