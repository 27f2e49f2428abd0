// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/plane_rate.hpp"

namespace triax::sim {

void hold_plane_strain(MixedControl<Tensor>& control) {
  for (const int fixed : {1, 3, 4, 5}) control.strain(fixed, fixed) = 1;
}

template <>
MixedControl<Axisymmetric> plane_control(ProbeKind kind, const PlaneVector& v) {
  const Vector<Axisymmetric> components(v.y(), v.x());
  return kind == ProbeKind::stress ? MixedControl<Axisymmetric>::stresses(components)
                                   : MixedControl<Axisymmetric>::strains(components);
}

template <>
MixedControl<Tensor> plane_control(ProbeKind kind, const PlaneVector& v) {
  MixedControl<Tensor> control;
  Matrix<Tensor>& rows = kind == ProbeKind::stress ? control.stress : control.strain;
  rows(0, 0) = rows(2, 2) = 1;
  control.increment << v.y(), 0, v.x(), 0, 0, 0;
  hold_plane_strain(control);
  return control;
}

PointRate<Axisymmetric> stress_rate(const IncrementalResponse<Axisymmetric>& response,
                                    double angle) {
  return response.to_stress({std::sin(angle), std::cos(angle)});
}

PointRate<Tensor> stress_rate(const IncrementalResponse<Tensor>& response, double angle) {
  return response.to(plane_control<Tensor>(ProbeKind::stress, unit_direction(angle)));
}

Probe probe_of(double angle, bool answered, const PlaneVector& stress, const PlaneVector& strain) {
  Probe probe{angle, answered};
  if (!answered) return probe;
  probe.stress = stress;
  probe.strain = strain;
  probe.second_order_work = stress.dot(strain);
  const double norms = stress.norm() * strain.norm();
  probe.normalised = norms > 0 ? probe.second_order_work / norms : 0;
  return probe;
}

Probe stress_probe(const PlaneVector& stress, const PlaneVector& strain) {
  const double norm = stress.norm();
  if (!(norm > 0)) return {};
  return probe_of(angle_of(stress), true, stress / norm, strain / norm);
}

}  // namespace triax::sim
