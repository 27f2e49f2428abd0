// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is imposed on a state in every direction of a plane, and how finely.
#include <vector>

#include "sim/stability/cones.hpp"
#include "src/study/probe/controllability.hpp"

namespace triax::study {

struct Probing {
  sim::ProbeKind kind = sim::ProbeKind::stress;
  sim::ProbePlane plane = sim::ProbePlane::axisymmetric;
  double norm = 1e3;    ///< of the increments, Pa; of strain probes, strain
  int directions = 36;  ///< equal steps, refined where the sign changes
  bool finite = false;  ///< increments of that norm are integrated; else the rate is scaled to it

  std::vector<double> ratios = usual_ratios();  ///< R at which control is looked at
  std::vector<sim::NamedControl> conditions;    ///< besides; axisymmetry only

  bool axisymmetric() const { return plane == sim::ProbePlane::axisymmetric; }

  double step_deg() const { return 360.0 / directions; }

  /// Of a circle of these probes: edges of cones by increments that are integrated are isolated to
  /// the round-off of the driver.
  sim::CircleOptions circle_options() const {
    sim::CircleOptions options{.directions = directions};
    if (finite) options.precision = 1e-6;
    return options;
  }
};

}  // namespace triax::study
