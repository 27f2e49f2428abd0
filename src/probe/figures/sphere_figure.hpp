// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Second-order work in every direction of the principal increments.
#include <Eigen/Core>
#include <vector>

#include "src/plot/drawing.hpp"
#include "src/plot/subject.hpp"

namespace triax::src {

struct SphereDirection {
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< of what is imposed, (1, 2, 3), unit
  Eigen::Vector3d response = Eigen::Vector3d::Zero();   ///< what it brings, in any unit
  bool answered = false;
  double normalised = 0;  ///< W₂/(|dσ| |dε|)
};

/// Lambert's azimuthal projection, which keeps areas, of a unit direction into a disc of radius 1
/// around ±(1, 1, 1)/√3; axis 1 points up, axis 2 to the lower right, axis 3 to the lower left in
/// both discs. `towards`: the disc of increments with a positive mean (compression).
QPointF lambert(const Eigen::Vector3d& direction, bool towards);
/// The direction that is seen at a place of a disc. Pre-condition: |place| ≤ 1.
Eigen::Vector3d direction_at(const QPointF& place, bool towards);

/// Normalised W₂ of all directions as two discs, towards the hydrostatic axis and away from it:
/// each place has the colour of the nearest direction given, blue where W₂ > 0, vermilion where W₂
/// < 0, grey without an answer. Drawn on top: the line W₂ = 0, interpolated between the directions,
/// the six half axes, the axisymmetric plane (components 2 and 3 alike), and where dε₂ = 0 (plane
/// strain). No plot without an answered direction.
Drawing sphere_figure(const std::vector<SphereDirection>& directions, const Subject& subject);

}  // namespace triax::src
