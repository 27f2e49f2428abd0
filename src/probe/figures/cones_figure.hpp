// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Cones of unstable stress directions at their states (Fig. 12 of the paper).
#include <QPointF>

#include "src/plot/drawing.hpp"
#include "src/plot/subject.hpp"
#include "src/study/probe/cones_picture.hpp"

namespace triax::src {

enum class StressAxes {
  p_q,       ///< q over p′
  rendulic,  ///< σ₁′ over √2 σ₃′, where α is the angle that is seen
};

/// Where a state lies in a plane, in the unit of the stress.
QPointF position(const study::TriaxialState& state, StressAxes plane);
/// The increment of unit norm √(dσ₁² + 2 dσ₃²) of a Rendulic angle as it is seen in a plane:
/// (cos α, sin α), or (dp′, dq) with dp′ = (dσ₁ + 2 dσ₃)/3, dq = dσ₁ − dσ₃. The map to p′-q is
/// linear but keeps no angles.
QPointF increment(double angle, StressAxes plane);

/// Each cone is a fan whose tip is its state; a state without one is a small ring. Arrows of the
/// tests start at their states, at a full dot for recorded ones, at an open one for simulated ones.
/// One unit of stress is as long on both axes. No plot without states and tests.
Drawing cones_figure(const study::ConesPicture& picture, const Subject& subject, StressAxes plane);

}  // namespace triax::src
