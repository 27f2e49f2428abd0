#include "sim/stability/plane_rate.hpp"

namespace triax::sim {

PointRate<Axisymmetric> stress_rate(const IncrementalResponse<Axisymmetric>& response,
                                    double angle) {
  return response.to_stress({std::sin(angle), std::cos(angle)});
}

PointRate<Tensor> stress_rate(const IncrementalResponse<Tensor>& response, double angle) {
  MixedControl<Tensor> control;
  control.increment << std::sin(angle), 0, std::cos(angle), 0, 0, 0;
  for (const int free : {0, 2}) control.stress(free, free) = 1;
  for (const int fixed : {1, 3, 4, 5}) control.strain(fixed, fixed) = 1;
  return response.to(control);
}

Probe stress_probe(const PlaneVector& stress, const PlaneVector& strain) {
  Probe probe;
  const double norm = stress.norm();
  if (!(norm > 0)) return probe;
  probe.answered = true;
  probe.stress = stress / norm;
  probe.strain = strain / norm;
  probe.angle = angle_of(stress);
  probe.second_order_work = probe.stress.dot(probe.strain);
  const double strain_norm = probe.strain.norm();
  probe.normalised = strain_norm > 0 ? probe.second_order_work / strain_norm : 0;
  return probe;
}

}  // namespace triax::sim
