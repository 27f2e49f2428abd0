// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/stability/cones.hpp"
#include "src/plot/drawing.hpp"
#include "src/plot/subject.hpp"

namespace triax::src {

/// The probes beside their answers (Fig. 13 of the paper): on the left the increments imposed, a
/// circle of radius `norm` (Pa for stress probes, a plain number for strain probes) with α every
/// 30°, on the right the envelope of the responses with the same marks: strain in 10⁻⁶, stress in
/// kPa. Directions with W₂ < 0 are vermilion and bolder. Answers of probes of another norm are
/// scaled to it, which is right for rates. No plot without an answered probe.
Drawing response_envelope(const sim::Circle& circle, double norm, const Subject& subject);

}  // namespace triax::src
