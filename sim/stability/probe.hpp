// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Probes: the answer of a state to an increment in a direction of a plane.
//
//   axisymmetric   x = √2 dσ₃, y = dσ₁   (Rendulic plane; strain √2 dε₃, dε₁)
//   plane strain   x = dσ₃, y = dσ₁      with dε₂ = 0, principal axes fixed (strain dε₃, dε₁)
//
// The angle α is measured from the x axis towards the y axis, as in Fig. 13 of the paper:
// dσ = |dσ| (x = cos α, y = sin α). Isotropic unloading is at 180° + atan(1/√2) = 215.26° in
// axisymmetry, at 225° in plane strain where dσ₁ = dσ₃ < 0. In both planes
//
//   W₂ = dσ′:dε = x_σ x_ε + y_σ y_ε   (Eq. 23, per unit volume)
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "sim/stability/incremental_response.hpp"

namespace triax::sim {

/// A vector of the plane, (x, y).
using PlaneVector = Eigen::Vector2d;

inline PlaneVector unit_direction(double angle) { return {std::cos(angle), std::sin(angle)}; }
/// In [0, 2π).
double angle_of(const PlaneVector& v);

/// Direction of isotropic unloading (dq = 0, dp′ < 0) in the Rendulic plane, 215.26°.
inline const double kIsotropicUnloading = std::numbers::pi + std::atan(std::numbers::sqrt2 / 2);

/// (x, y) of an increment of a triaxial test.
inline PlaneVector rendulic(const Vector<Axisymmetric>& v) { return {v(1), v(0)}; }

struct Probe {
  double angle = 0;       ///< α, rad, of the imposed increment
  bool answered = false;  ///< false: the law has no answer in this direction (its limit)
  PlaneVector stress = PlaneVector::Zero();  ///< Pa
  PlaneVector strain = PlaneVector::Zero();
  double second_order_work = 0;  ///< dσ′:dε, Pa
  /// dσ′:dε/(|dσ′| |dε|) in [−1, 1], the cosine of the angle between them; norms in the plane.
  double normalised = 0;
  bool refused = false;  ///< not answered because the law refuses the direction or fails there
};

/// What is imposed in the direction α.
enum class ProbeKind { stress, strain };
enum class ProbePlane { axisymmetric, plane_strain };

/// Answers a direction; has no state that changes.
using Prober = std::function<Probe(double angle)>;

/// Increments of unit norm (1 Pa, or strain 1) along the law's answer at the state, linear in the
/// norm. `response` is shared with the prober.
Prober make_prober(std::shared_ptr<const IncrementalResponse<Axisymmetric>> response,
                   ProbeKind kind);
/// In plane strain.
Prober make_prober(std::shared_ptr<const IncrementalResponse<Tensor>> response, ProbeKind kind);

/// The same with increments of a norm (Pa, or strain) that the point driver integrates: what a
/// probe of an experiment or of a discrete specimen is. An increment that does not arrive whole is
/// not answered. The law must outlive the prober.
Prober make_finite_prober(const Law<Axisymmetric>& law, const PointState<Axisymmetric>& state,
                          ProbeKind kind, double norm);
Prober make_finite_prober(const Law<Tensor>& law, const PointState<Tensor>& state, ProbeKind kind,
                          double norm);

/// Direction of dσ₁ = dσ₃ < 0 (and dσ₂ alike in axisymmetry) in the plane of stress probes, rad.
double isotropic_unloading(sim::ProbePlane plane);

}  // namespace triax::sim
