// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/probe.hpp"

#include "sim/point/point_driver.hpp"
#include "sim/stability/plane_rate.hpp"
#include "sim/stability/stress_plane.hpp"

namespace triax::sim {
namespace {

template <class Space>
Prober finite_prober(const Law<Space>& law, const PointState<Space>& state, ProbeKind kind,
                     double norm) {
  return [&law, state, kind, norm](double angle) {
    const auto step =
        advance_point(law, state, plane_control<Space>(kind, norm * unit_direction(angle)));
    const bool whole = step.outcome == StepOutcome::accepted ||
                       (step.outcome == StepOutcome::inaccurate && step.done == 1);
    Probe probe =
        probe_of(angle, whole, in_plane(step.stress_increment), in_plane(step.strain_increment));
    probe.refused = step.outcome == StepOutcome::failed;
    return probe;
  };
}

template <class Rate>
Probe probe_of_rate(double angle, const Rate& rate) {
  Probe probe = probe_of(angle, rate.controllable, in_plane(rate.stress), in_plane(rate.strain));
  probe.refused = !rate.controllable && rate.limiting_variable == kRefused;
  return probe;
}

template <class Space>
Prober rate_prober(std::shared_ptr<const IncrementalResponse<Space>> response, ProbeKind kind) {
  const auto ask = [response, kind](double angle, const PlaneVector& v) {
    return probe_of_rate(angle, response->to(plane_control<Space>(kind, v)));
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

double isotropic_unloading(ProbePlane plane) {
  return plane == ProbePlane::axisymmetric ? kIsotropicUnloading : 1.25 * std::numbers::pi;
}

}  // namespace triax::sim
