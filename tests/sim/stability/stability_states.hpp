// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>

#include "sim/mechanics/units.hpp"
#include "sim/stability/cones.hpp"
#include "tests/sim/materials/hypoplastic_sets.hpp"
#include "tests/sim/materials/interpolated_laws.hpp"

// States that tests of the stability look at.
namespace triax::sim::test {

/// Start at p (kPa) and η in triaxial compression (η < 0: extension), without a reversal behind it.
template <class Space>
std::shared_ptr<const IncrementalResponse<Space>> response_at(const Law<Space>& law, double p_kPa,
                                                              double eta, double e) {
  const double q = eta * p_kPa;
  const auto stress =
      components(AxisymmetricStress{1e3 * (p_kPa + 2 * q / 3), 1e3 * (p_kPa - q / 3)});
  if constexpr (Space::kSize == 2)
    return std::make_shared<IncrementalResponse<Space>>(law, law.start(stress, e));
  else
    return std::make_shared<IncrementalResponse<Space>>(law, law.start(as_tensor(stress), e));
}

template <class Space>
Circle circle_at(const Law<Space>& law, double p_kPa, double eta, double e,
                 ProbeKind kind = ProbeKind::stress, int directions = 36) {
  return probe_circle(make_prober(response_at(law, p_kPa, eta, e), kind),
                      {.directions = directions});
}

}  // namespace triax::sim::test
