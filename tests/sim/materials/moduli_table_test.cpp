// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/moduli_table.hpp"

#include <catch2/catch.hpp>

#include "sim/point/point_driver.hpp"
#include "tests/sim/materials/interpolated_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;
using Control = MixedControl<Axisymmetric>;
using State = PointState<Axisymmetric>;

TEST_CASE("equal moduli in loading and unloading are linear elasticity") {
  ParameterSet set;
  set.lists["stress_ratios"] = {-1, 1};
  for (const char* side : {"plus", "minus"}) {
    const std::string s = side;
    set.lists["E1_" + s + "_kPa"] = set.lists["E3_" + s + "_kPa"] = {20e3, 20e3};
    set.lists["V13_" + s] = set.lists["V31_" + s] = set.lists["V33_" + s] = {0.2, 0.2};
  }
  const Interpolated<Axisymmetric> material(Interpolation::inl2,
                                            std::make_shared<ModuliTable>(set));
  const State s = state_at(material, 100, 0.3, 0.9);
  const Matrix<Axisymmetric> elastic = isotropic_stiffness<Axisymmetric>(20e6 / 1.8, 20e6 / 2.4);
  for (const Vector<Axisymmetric>& d : {Vector<Axisymmetric>(1, 2), Vector<Axisymmetric>(-3, 1)}) {
    const auto rate = point_rate<Axisymmetric>(material, s, Control::strains(1e-5 * d));
    CHECK(rate.stress.isApprox(elastic * (1e-5 * d), 1e-12));
  }
  CHECK(material.objection(state_at(material, 100, 1.1, 0.9)));
  set.lists["E1_plus_kPa"] = {20e3};
  CHECK_THROWS_WITH(ModuliTable(set), Catch::Contains("E1_plus_kPa has 1 numbers"));
}
