// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The friction of compaction that gives a specimen the porosity wanted.
#include "sim/grains/specimens/assembly.hpp"

namespace triax::sim {

struct PorositySearch {
  double porosity = 0.402;              ///< wanted, at the pressure
  double tolerance = 0.001;             ///< > 0
  double lowest_friction = 0.0174533;   ///< rad; bracket, here 1° …
  double highest_friction = 1.0471976;  ///< … to 60°
  int most_trials = 10;
};

struct PorosityFound {
  Compacted best;             ///< of the trials, the nearest to what was wanted
  double friction_angle = 0;  ///< that it was compacted with, rad
  bool reached = false;       ///< within the tolerance
  bool above_bracket = false, below_bracket = false;  ///< the wanted one lies beyond the bracket
  int trials = 0;                                     ///< compactions made
};

/// Seeks the friction of compaction that gives a porosity, by compressing the whole specimen each
/// time (a smaller one has more boundary and is looser). Porosity rises about linearly with the
/// logarithm of the friction angle, which a bracketed secant uses (Illinois variant of the regula
/// falsi). Throws as compact(), and std::invalid_argument on a bracket out of order.
PorosityFound seek_porosity(const Cloud& cloud, const ContactLaw& law, const Compaction& how,
                            const PorositySearch& search, int threads = 1,
                            const GrainProgress& progress = {});

}  // namespace triax::sim
