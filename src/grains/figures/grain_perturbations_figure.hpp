// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "sim/grains/probes/perturbation.hpp"
#include "src/plot/drawing.hpp"
#include "src/plot/subject.hpp"

namespace triax::src {

struct DrawnPerturbation {
  std::string title;  ///< "ES_a + 500 Pa: at rest"
  std::vector<sim::PerturbationPoint> points;
};

/// Figs. 17 and 18: χ (left axis) and kinetic energy (right axis) over the time since the
/// perturbation, a panel each, at most three in a row. Panels have ranges of their own. No plot
/// without a point.
Drawing grain_perturbations_figure(const std::vector<DrawnPerturbation>& all,
                                   const Subject& subject);

}  // namespace triax::src
