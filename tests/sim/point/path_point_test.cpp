// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/path_point.hpp"

#include <catch2/catch.hpp>

using namespace triax::sim;
using Q = PathQuantity;

TEST_CASE("quantities of a triaxial point, effective and total") {
  PathPoint<Axisymmetric> at;
  at.stress = components(AxisymmetricStress{90e3, 30e3});
  at.strain = components(AxisymmetricStrain{0.05, -0.02});
  at.pore_pressure = 200e3;
  at.void_ratio = 0.8;
  const auto value = [&](PathQuantity quantity) { return value_of(quantity, 0, at).value(); };
  CHECK(value(Q::axial_strain) == 0.05);
  CHECK(value(Q::radial_strain) == Approx(-0.02));
  CHECK(value(Q::volumetric_strain) == Approx(0.01));
  CHECK(value(Q::shear_strain) == Approx(2 * 0.07 / 3));
  CHECK(value(Q::mean_effective_stress) == Approx(50e3));
  CHECK(value(Q::mean_total_stress) == Approx(250e3));
  CHECK(value(Q::deviator_stress) == Approx(60e3));
  CHECK(value(Q::stress_ratio) == Approx(1.2));
  CHECK(value(Q::axial_stress) == Approx(290e3));
  CHECK(value(Q::radial_stress) == Approx(230e3));
  CHECK(value(Q::effective_axial_stress) == Approx(90e3));
  CHECK(value(Q::effective_radial_stress) == Approx(30e3));
  CHECK(value(Q::pore_pressure) == 200e3);
  CHECK(value(Q::void_ratio) == 0.8);
  at.stress.setZero();
  CHECK_FALSE(value_of(Q::stress_ratio, 0, at));
}

TEST_CASE("of a tensor axial is 11, radial the mean of the others, q a norm") {
  PathPoint<Tensor> at;
  at.stress << 30e3, 80e3, 100e3, 0, 0, 5e3 * std::numbers::sqrt2;
  CHECK(value_of(Q::effective_axial_stress, 0, at) == 30e3);
  CHECK(value_of(Q::effective_radial_stress, 0, at) == 90e3);
  CHECK(value_of(Q::deviator_stress, 0, at).value() > 0);
  at.pore_pressure = 7e3;
  CHECK(value_of(Q::stress_component, 2, at) == 107e3);
  CHECK(value_of(Q::stress_component, 5, at).value() == Approx(5e3));
  CHECK(value_of(Q::effective_stress_component, 1, at) == 80e3);
}
