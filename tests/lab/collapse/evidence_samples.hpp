// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Findings of simple tests, from which results are assessed.
#include "lab/collapse/assessment.hpp"
#include "sim/mechanics/axisymmetric.hpp"

namespace triax::lab::samples {

/// A descent from q and p' (Pa) at reading 10.
inline Descent descent(double q_onset, double p_eff, double q_lost, double q_regained) {
  Descent d;
  d.onset.reading = 10;
  d.onset.q = q_onset;
  d.onset.p_eff = p_eff;
  d.evidence.work.normalised = -0.2;
  d.q_lost = q_lost;
  d.q_least = q_onset - q_lost;
  d.q_regained = q_regained;
  return d;
}

/// A given friction angle of 32°: q = 1.29 p'.
inline LimitSurface sand() {
  SpecimenInfo specimen;
  specimen.limit_friction_angle_rad = sim::radians(32);
  return LimitSurface(specimen);
}

}  // namespace triax::lab::samples
