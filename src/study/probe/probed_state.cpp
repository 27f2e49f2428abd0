// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/probed_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "lab/base/bad_input.hpp"
#include "sim/point/point_driver.hpp"
#include "sim/stability/plane_rate.hpp"

namespace triax::study {
namespace {

void scale(sim::Probe& probe, double norm) {
  probe.stress *= norm;
  probe.strain *= norm;
  probe.second_order_work *= norm * norm;
}

void scale(sim::Circle& circle, double norm) {
  for (sim::Probe& probe : circle.probes) scale(probe, norm);
  for (sim::Cone& cone : circle.cones) scale(cone.strongest, norm);
  scale(circle.least, norm);
}

/// Probers of one state; increments of unit norm, those of finite ones of the norm.
template <class Space>
class StateProbers {
 public:
  StateProbers(const sim::Law<Space>& law, const sim::PointState<Space>& state,
               const Probing& probing)
      : law_(law),
        state_(state),
        probing_(probing),
        response_(std::make_shared<const sim::IncrementalResponse<Space>>(law, state)) {}

  sim::Circle circle() const {
    sim::Circle circle = sim::probe_circle(prober(probing_.kind), probing_.circle_options());
    if (!probing_.finite) scale(circle, probing_.norm);
    return circle;
  }

  /// A stress increment: of the norm where that is one of stress, else of 1 kPa along the rate.
  sim::Probe stress_probe(double angle) const {
    const bool of_norm = probing_.kind == sim::ProbeKind::stress;
    sim::Probe probe = of_norm ? prober(sim::ProbeKind::stress)(angle)
                               : sim::make_prober(response_, sim::ProbeKind::stress)(angle);
    if (!(of_norm && probing_.finite)) scale(probe, of_norm ? probing_.norm : 1e3);
    return probe;
  }

  Controllability control(const sim::Probe& least) const {
    return control_of(*response_, least, probing_.ratios, probing_.conditions);
  }

  /// Empty unless the law is octolinear and the probes are of stress.
  std::optional<std::vector<sim::UnstableSector>> closed_form() const {
    const auto* form = std::get_if<sim::InterpolatedForm<Space>>(&response_->response());
    if (form == nullptr || form->quadratic || probing_.kind != sim::ProbeKind::stress)
      return std::nullopt;
    if constexpr (Space::kSize == 6)
      if (!sim::answers_in_plane_strain(*form)) return std::nullopt;
    return sim::unstable_sectors(sim::octolinear_zones(*form));
  }

  /// The words on the first direction that is refused.
  std::string refusal(const sim::Circle& circle) const {
    for (const sim::Probe& probe : circle.probes)
      if (probe.refused)
        if (auto words = why_refused(probe.angle)) return *words;
    return {};
  }

 private:
  std::optional<std::string> why_refused(double angle) const {
    const sim::PlaneVector direction = sim::unit_direction(angle);
    const auto unit = sim::plane_control<Space>(probing_.kind, direction);
    if (!law_.finite() && !probing_.finite)
      return law_.refusal(state_, sim::point_rate(law_, state_, unit));
    const double small = probing_.kind == sim::ProbeKind::stress ? 1 : 1e-7;
    const auto step = sim::advance_point(
        law_, state_,
        sim::plane_control<Space>(probing_.kind,
                                  (probing_.finite ? probing_.norm : small) * direction));
    if (step.message.empty()) return std::nullopt;
    return step.message;
  }

  sim::Prober prober(sim::ProbeKind kind) const {
    return probing_.finite ? sim::make_finite_prober(law_, state_, kind, probing_.norm)
                           : sim::make_prober(response_, kind);
  }

  const sim::Law<Space>& law_;
  const sim::PointState<Space>& state_;
  const Probing& probing_;
  std::shared_ptr<const sim::IncrementalResponse<Space>> response_;
};

}  // namespace

FirstUnstable ProbedState::as_first() const {
  return {p, q, void_ratio, axial_strain, circle.least.angle};
}

template <class Space>
sim::Circle probed_circle(const lab::MaterialSet& material, const StateToProbe<Space>& what,
                          const Probing& probing) {
  return StateProbers<Space>(*material.material.law<Space>(), what.state, probing).circle();
}

template <class Space>
ProbedState probe_state(const lab::MaterialSet& material, const StateToProbe<Space>& what,
                        const Probing& probing) {
  ProbedState probed;
  static_cast<StateHead&>(probed) = head_of(material, what);
  const StateProbers<Space> probers(*material.material.law<Space>(), what.state, probing);
  probed.circle = probers.circle();
  probed.control = probers.control(probed.circle.least);
  probed.isotropic_unloading = probers.stress_probe(isotropic_unloading(probing.plane));
  if (what.test && what.test->increment && probing.plane == sim::ProbePlane::axisymmetric)
    probed.own = probers.stress_probe(what.test->increment->angle);
  if (probed.own && probing.kind == sim::ProbeKind::stress)
    probed.own_place = place_among(probed.circle.cones, what.test->increment->angle);
  probed.closed_form = probers.closed_form();
  if (probed.circle.refused == 0) return probed;
  probed.refusal = probers.refusal(probed.circle);
  if (material.material.law<Space>()->finite())
    probed.warnings.push_back(fmt::format("the law gives no result in {} of {} directions{}{}",
                                          probed.circle.refused, probing.directions,
                                          probed.refusal.empty() ? "" : ": ", probed.refusal));
  return probed;
}

template ProbedState probe_state(const lab::MaterialSet&, const StateToProbe<sim::Axisymmetric>&,
                                 const Probing&);
template ProbedState probe_state(const lab::MaterialSet&, const StateToProbe<sim::Tensor>&,
                                 const Probing&);
template sim::Circle probed_circle(const lab::MaterialSet&, const StateToProbe<sim::Axisymmetric>&,
                                   const Probing&);
template sim::Circle probed_circle(const lab::MaterialSet&, const StateToProbe<sim::Tensor>&,
                                   const Probing&);

}  // namespace triax::study
