// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Probes in three dimensions: every direction of the principal increments (dσ₁, dσ₂, dσ₃) along the
// axes of the state, and the least second-order work over all six components, rotations of the
// axes included.
#include <vector>

#include "sim/stability/cones.hpp"

namespace triax::sim {

struct SphereProbe {
  /// Polar angle from the hydrostatic axis (1, 1, 1)/√3, 0 … π, rad.
  double polar = 0;
  /// Azimuth around it from the compression of axis 1, (2, −1, −1)/√6, towards axis 2, rad:
  /// Lode's angle of the increment.
  double azimuth = 0;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< of what is imposed, unit
  Eigen::Vector3d response = Eigen::Vector3d::Zero();   ///< strain per Pa, or stress (Pa)
  bool answered = false;
  double normalised = 0;  ///< dσ′:dε/(|dσ′| |dε|)
};

/// Direction of a polar angle and an azimuth.
Eigen::Vector3d sphere_direction(double polar, double azimuth);

/// One direction, imposed along the axes of the state without shear components.
SphereProbe probe_direction(const IncrementalResponse<Tensor>& response, ProbeKind kind,
                            const Eigen::Vector3d& direction);

/// Second-order work over the sphere, in cells of equal steps in both angles.
struct Sphere {
  int rings = 0, sectors = 0;       ///< cells in polar angle and in azimuth
  std::vector<SphereProbe> probes;  ///< at the centres of the cells, ring after ring
  SphereProbe least;                ///< the direction of least normalised W₂, refined
  /// Solid angle with W₂ < 0 over 4π, by cells, those at its boundary cut into 6 × 6.
  double unstable_share = 0;
  int regions = 0;  ///< connected ones of cells with W₂ < 0, one if only `least` is in it
  int unanswered = 0;
  bool unstable() const { return least.answered && least.normalised < kUnstable; }
};

/// `rings` at least 6; twice as many sectors.
Sphere probe_sphere(const IncrementalResponse<Tensor>& response, ProbeKind kind, int rings = 36);

/// A direction of all six orthonormal components.
struct FreeProbe {
  Vector<Tensor> direction = Vector<Tensor>::Zero();  ///< of what is imposed, unit
  bool answered = false;
  double normalised = 0;
};

/// The least normalised W₂ over all six components, found by descents from the axes, from the least
/// direction of the sphere and from `starts` other directions (the same ones each time). A local
/// minimum that none of them leads to is missed.
FreeProbe least_of_all_directions(const IncrementalResponse<Tensor>& response, ProbeKind kind,
                                  const SphereProbe& start, int starts = 24);

}  // namespace triax::sim
