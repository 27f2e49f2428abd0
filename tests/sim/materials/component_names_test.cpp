// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/component_names.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/materials/sanisand.hpp"
#include "sim/materials/sanisand_moduli.hpp"
#include "tests/sim/materials/parameter_sets.hpp"

using namespace triax::sim;

namespace {

template <class Space>
double named(const Law<Space>& law, const PointState<Space>& state, const std::string& name) {
  const auto names = law.memory_names();
  REQUIRE(static_cast<Eigen::Index>(names.size()) == state.memory.size());
  const auto found = std::find(names.begin(), names.end(), name);
  REQUIRE(found != names.end());
  return state.memory(found - names.begin());
}

}  // namespace

TEST_CASE("a memory of a tensor that is root 2 times its component says so in its name") {
  const auto p = test::s28_general();
  // α stands behind the stress ratio by the radius of the yield surface, along s.
  Eigen::Matrix3d stress;
  stress << 150e3, 30e3, 0, 30e3, 90e3, 0, 0, 0, 60e3;
  const Sanisand<Tensor> tensor(p);
  const auto state = tensor.start(components(stress), 0.9);
  const Eigen::Matrix3d ratio = stress / 100e3 - Eigen::Matrix3d::Identity();
  const double share = 1 - std::sqrt(2.0 / 3) * p.yield_radius / ratio.norm();
  CHECK(named(tensor, state, "alpha_11") == Approx(share * ratio(0, 0)));
  CHECK(named(tensor, state, "alpha_12_root2") == Approx(std::sqrt(2.0) * share * ratio(0, 1)));

  const Sanisand<Axisymmetric> triaxial(p);
  const auto sheared = triaxial.start(components(AxisymmetricStress{160e3, 70e3}), 0.9);
  const double axial = named(triaxial, sheared, "alpha_axial");
  CHECK(named(triaxial, sheared, "alpha_radial_root2") == Approx(-axial / std::sqrt(2.0)));
}

TEST_CASE("every entry of a memory has a name of its own, in both spaces") {
  const auto apart = [](std::vector<std::string> names, Eigen::Index size) {
    CHECK(static_cast<Eigen::Index>(names.size()) == size);
    for (const std::string& name : names)
      if (name.find("_12") != std::string::npos || name.find("radial") != std::string::npos)
        CHECK(name.find("_root2") != std::string::npos);
    std::sort(names.begin(), names.end());
    CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
  };
  const SanisandModuli<Tensor> moduli(test::s28_general());
  apart(moduli.memory_names(), moduli.start(isotropic<Tensor>(1e5), 0.9).memory.size());
  const SanisandModuli<Axisymmetric> flat(test::s28_general());
  apart(flat.memory_names(), flat.start(isotropic<Axisymmetric>(1e5), 0.9).memory.size());
}
