// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Circles of a law with printed cones: INL2, S28-general, e = 1.086, p′ = 70 kPa.
#include <memory>

#include "sim/stability/cones.hpp"
#include "src/plot/subject.hpp"
#include "tests/sim/materials/interpolated_laws.hpp"

namespace triax::src::test {

inline sim::Circle inl2_circle(double eta, sim::ProbeKind kind = sim::ProbeKind::stress) {
  static const auto kLaw = sim::test::inl2();
  const auto state = sim::test::state_at(kLaw, 70, eta, 1.086);
  return sim::probe_circle(sim::make_prober(
      std::make_shared<const sim::IncrementalResponse<sim::Axisymmetric>>(kLaw, state), kind));
}

inline Subject subject() { return {"inl2/S28-general", "p′ = 70 kPa, e = 1.086"}; }

/// Probes whose W₂ is given, every 10°.
template <class Value>
sim::Circle invented_circle(const Value& value) {
  sim::Circle circle;
  for (int i = 0; i < 36; ++i) {
    sim::Probe probe{sim::radians(10 * i), true};
    probe.stress = 1e3 * sim::unit_direction(probe.angle);
    probe.strain = 1e-4 * sim::unit_direction(probe.angle);
    probe.normalised = value(probe.angle);
    probe.second_order_work = 0.1 * probe.normalised;
    circle.probes.push_back(probe);
  }
  return circle;
}

}  // namespace triax::src::test
