// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rates of a law in the plane of the probes (probe.hpp): axisymmetric where the law is, plane
// strain where it is one of full tensors.
#include "sim/stability/probe.hpp"

namespace triax::sim {

template <class Space>
inline constexpr ProbePlane kPlane =
    Space::kSize == 2 ? ProbePlane::axisymmetric : ProbePlane::plane_strain;

/// (x, y) of a vector.
inline PlaneVector in_plane(const Vector<Axisymmetric>& v) { return rendulic(v); }
inline PlaneVector in_plane(const Vector<Tensor>& v) { return {v(2), v(0)}; }

/// The control that imposes an increment of the plane (Pa, or strain); in plane strain all other
/// strains are kept at zero.
template <class Space>
MixedControl<Space> plane_control(ProbeKind kind, const PlaneVector& increment);
/// Adds to `control` that all strains out of the plane are kept at zero.
void hold_plane_strain(MixedControl<Tensor>& control);

/// An increment and what answered it, as a probe in the direction α.
Probe probe_of(double angle, bool answered, const PlaneVector& stress, const PlaneVector& strain);

/// The rate that a stress increment of 1 Pa in the direction α brings.
PointRate<Axisymmetric> stress_rate(const IncrementalResponse<Axisymmetric>& response,
                                    double angle);
PointRate<Tensor> stress_rate(const IncrementalResponse<Tensor>& response, double angle);

/// A rate as a probe of its own stress direction, scaled to 1 Pa; not answered where the rate is
/// not controllable or has no stress.
Probe stress_probe(const PlaneVector& stress, const PlaneVector& strain);
template <class Space>
Probe stress_probe(const PointRate<Space>& rate) {
  return rate.controllable ? stress_probe(in_plane(rate.stress), in_plane(rate.strain)) : Probe{};
}

}  // namespace triax::sim
