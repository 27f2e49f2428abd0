// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/sim/stability/stability_states.hpp"

// The laws that the tests of stability compare, with sets like S28.
namespace triax::sim::test {

inline Sanisand<Axisymmetric> sanisand() { return Sanisand<Axisymmetric>(s28_general()); }
inline Hypoplastic<Axisymmetric> hypoplastic() {
  return Hypoplastic<Axisymmetric>(hostun_moist_tamped());
}

struct NamedLaw {
  std::string name;
  std::shared_ptr<const Law<Axisymmetric>> law;
};
inline std::vector<NamedLaw> stability_laws() {
  return {{"INL2", std::make_shared<Interpolated<Axisymmetric>>(inl2())},
          {"octolinear", std::make_shared<Interpolated<Axisymmetric>>(octo())},
          {"SANISAND", std::make_shared<Sanisand<Axisymmetric>>(sanisand())},
          {"hypoplastic", std::make_shared<Hypoplastic<Axisymmetric>>(hypoplastic())}};
}

template <class Space>
Prober stress_prober(const Law<Space>& law, const PointState<Space>& state) {
  return make_prober(std::make_shared<const IncrementalResponse<Space>>(law, state),
                     ProbeKind::stress);
}

}  // namespace triax::sim::test
