#include "sim/stability/probe.hpp"

#include "sim/point/point_driver.hpp"
#include "sim/stability/stress_plane.hpp"

namespace triax::sim {
namespace {

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

PlaneVector in_plane(const Vector<Axisymmetric>& v) { return rendulic(v); }
PlaneVector in_plane(const Vector<Tensor>& v) { return {v(2), v(0)}; }

/// The control that imposes a vector of the plane.
MixedControl<Axisymmetric> imposed(ProbeKind kind, const PlaneVector& v, const Axisymmetric&) {
  const Vector<Axisymmetric> components(v.y(), v.x());
  return kind == ProbeKind::stress ? MixedControl<Axisymmetric>::stresses(components)
                                   : MixedControl<Axisymmetric>::strains(components);
}
MixedControl<Tensor> imposed(ProbeKind kind, const PlaneVector& v, const Tensor&) {
  MixedControl<Tensor> control;
  Matrix<Tensor>& rows = kind == ProbeKind::stress ? control.stress : control.strain;
  rows(0, 0) = rows(2, 2) = 1;
  control.increment << v.y(), 0, v.x(), 0, 0, 0;
  for (const int fixed : {1, 3, 4, 5}) control.strain(fixed, fixed) = 1;
  return control;
}

template <class Space>
Prober finite_prober(const Law<Space>& law, const PointState<Space>& state, ProbeKind kind,
                     double norm) {
  return [&law, state, kind, norm](double angle) {
    const auto step =
        advance_point(law, state, imposed(kind, norm * unit_direction(angle), Space()));
    const bool whole = step.outcome == StepOutcome::accepted ||
                       (step.outcome == StepOutcome::inaccurate && step.done == 1);
    return probe_of(angle, whole, in_plane(step.stress_increment), in_plane(step.strain_increment));
  };
}

template <class Rate>
Probe probe_of_rate(double angle, const Rate& rate) {
  Probe probe = probe_of(angle, rate.controllable, in_plane(rate.stress), in_plane(rate.strain));
  probe.refused = !rate.controllable && rate.culprit == kRefused;
  return probe;
}

template <class Space>
Prober rate_prober(std::shared_ptr<const IncrementalResponse<Space>> response, ProbeKind kind) {
  const auto ask = [response, kind](double angle, const PlaneVector& v) {
    return probe_of_rate(angle, response->to(imposed(kind, v, Space())));
  };
  if (kind == ProbeKind::strain || response->law().finite())
    return [ask](double angle) { return ask(angle, unit_direction(angle)); };
  return [ask, plane = StressPlane<Space>(std::move(response))](double angle) {
    const PlaneVector v = unit_direction(angle);
    const auto answer = plane.to(v.y(), v.x());
    if (!answer) return ask(angle, v);
    Probe probe = probe_of(angle, answer->answered, v,
                           PlaneVector(answer->radial_strain, answer->axial_strain));
    probe.refused = answer->refused;
    return probe;
  };
}

}  // namespace

double angle_of(const PlaneVector& v) {
  const double angle = std::atan2(v.y(), v.x());
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

Prober make_prober(std::shared_ptr<const IncrementalResponse<Axisymmetric>> response,
                   ProbeKind kind) {
  return rate_prober(std::move(response), kind);
}
Prober make_prober(std::shared_ptr<const IncrementalResponse<Tensor>> response, ProbeKind kind) {
  return rate_prober(std::move(response), kind);
}

Prober make_finite_prober(const Law<Axisymmetric>& law, const PointState<Axisymmetric>& state,
                          ProbeKind kind, double norm) {
  return finite_prober(law, state, kind, norm);
}
Prober make_finite_prober(const Law<Tensor>& law, const PointState<Tensor>& state, ProbeKind kind,
                          double norm) {
  return finite_prober(law, state, kind, norm);
}

}  // namespace triax::sim
