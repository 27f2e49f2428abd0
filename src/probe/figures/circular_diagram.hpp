// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The second-order work around the directions of increments (Fig. 11 and 14 of the paper).
#include <string>
#include <vector>

#include "sim/stability/cones.hpp"
#include "src/plot/drawing.hpp"
#include "src/plot/subject.hpp"

namespace triax::src {

/// The probes of one state; `name` tells it from others in one diagram: "η = 0.60".
struct NamedCircle {
  std::string name;
  sim::Circle circle;  ///< with its probes
};

/// Constant that a circular diagram adds to the normalised W₂ so that no radius is near 0: a
/// multiple of 0.5 at least 0.3 above the least value of all.
double circular_constant(const std::vector<NamedCircle>& circles);

/// Radius r = W₂/(|dσ| |dε|) + constant in the direction α, with the circle W₂ = 0. Blue outside of
/// it (W₂ > 0), vermilion and bolder inside; a line style a state. Nothing is drawn where the law
/// has no answer. No plot without an answered probe.
Drawing circular_diagram(const std::vector<NamedCircle>& circles, const Subject& subject);

/// Radius |W₂|/(|dσ| |dε|) in the direction α: blue where W₂ > 0, vermilion and bolder where W₂ <
/// 0.
Drawing polar_diagram(const std::vector<NamedCircle>& circles, const Subject& subject);

}  // namespace triax::src
