// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/sphere.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace triax::study {

SphereIncrement increment_of(const sim::SphereProbe& probe, const SphereProbing& probing) {
  const Eigen::Vector3d imposed = probing.norm * probe.direction,
                        response = probing.norm * probe.response;
  const bool of_stress = probing.kind == sim::ProbeKind::stress;
  SphereIncrement increment{of_stress ? imposed : response, of_stress ? response : imposed, 0};
  increment.second_order_work = increment.stress.dot(increment.strain);
  return increment;
}

ProbedSphere probe_sphere_of(const lab::MaterialSet& material,
                             const StateToProbe<sim::Tensor>& what, const SphereProbing& probing) {
  ProbedSphere probed{head_of(material, what), {}, {}, {}};
  const sim::IncrementalResponse<sim::Tensor> response(*material.material.tensor, what.state);
  probed.sphere = sim::probe_sphere(response, probing.kind, probing.rings);
  probed.least = sim::least_of_all_directions(response, probing.kind, probed.sphere.least);
  if (what.test && what.test->increment) {
    const double angle = what.test->increment->angle,
                 radial = std::cos(angle) / std::numbers::sqrt2;
    probed.own =
        sim::probe_direction(response, sim::ProbeKind::stress, {std::sin(angle), radial, radial});
  }
  return probed;
}

bool SphereResult::any_answer() const {
  return std::ranges::any_of(states, [](const auto& s) { return s.sphere.least.answered; });
}

}  // namespace triax::study
