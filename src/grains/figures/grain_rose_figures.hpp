// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The probes of a specimen of grains (Figs. 13, 14 and 15 of the paper). Probes that were stopped
// are left out; without another there is no plot.
#include "sim/grains/probes/grain_probe.hpp"
#include "src/plot/drawing.hpp"
#include "src/plot/subject.hpp"

namespace triax::src {

/// Fig. 13: the probes of norm `norm` (Pa, or a strain, as the subject's kind says) and the
/// envelope of what answers them, both as they are. Directions with W₂ < 0 (Eq. 7) are vermilion;
/// those that did not come to rest are left out.
Drawing grain_envelope_figure(const sim::ProbeRose& rose, double norm, const Subject& subject);

/// Fig. 14: densities of second-order work over α. Left the semi-Lagrangian one (7), the Eulerian
/// one (10) and its three parts, with directions of W₂ < 0 shaded; right the macroscopic one (7)
/// and the microscopic one (11), with what the turning of grains and contacts explains of their
/// difference, and directions shaded in which they agree (kAgreement).
/// Directions that did not come to rest are shaded grey and have no values. What is shaded
/// reaches half a step beyond the probes.
Drawing grain_work_figure(const sim::ProbeRose& rose, const Subject& subject);

/// Fig. 15: left the shares of sliding and of non-permanent contacts, with the irreversible range
/// shaded (kIrreversible); right the largest kinetic energy, with the range of motion shaded
/// (kDynamic) and the null probe's as a dotted line, where that is not far below.
Drawing grain_contacts_figure(const sim::ProbeRose& rose, const Subject& subject);

}  // namespace triax::src
