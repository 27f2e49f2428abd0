// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "src/probe/figures/circular_diagram.hpp"

namespace triax::src {

/// Normalised W₂ over α from 0° to 360° with the line W₂ = 0, a curve a state, and the cones of
/// negative W₂ shaded; each cone's edges are those of its Circle, whether or not probes lie there.
/// No plot without an answered probe.
Drawing work_over_angle(const std::vector<NamedCircle>& circles, const Subject& subject);

}  // namespace triax::src
