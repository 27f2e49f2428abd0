// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/control/mixed_control.hpp"

#include <catch2/catch.hpp>

using namespace triax::sim;

TEMPLATE_TEST_CASE("named paths say what their names promise", "", Axisymmetric, Tensor) {
  using Control = MixedControl<TestType>;
  const auto in_space = [](double axial, double radial) {
    if constexpr (TestType::kSize == 2)
      return components(AxisymmetricStress{axial, radial});
    else
      return as_tensor(components(AxisymmetricStress{axial, radial}));
  };
  const auto met = [](const Control& c, const auto& stress, const auto& strain) {
    return (c.stress * stress + c.strain * strain - c.increment).norm() < 1e-13;
  };
  const auto none = in_space(0, 0);
  CHECK(met(Control::strain_path(0.02), none, in_space(0.02, -0.01)));
  CHECK(met(Control::strain_path(0.02, 0.8), none, in_space(0.02, -0.0125)));
  CHECK_FALSE(met(Control::strain_path(0.02, 0.8), none, in_space(0.02, -0.01)));
  CHECK(met(Control::stress_path(5, 9), in_space(11, 2), none));
  CHECK_FALSE(met(Control::stress_path(5, 9), in_space(11, 3), none));
  CHECK(met(Control::drained_compression(0.02), in_space(7, 0), in_space(0.02, 5)));
  CHECK(met(Control::strains(in_space(1, 2)), in_space(3, 4), in_space(1, 2)));
  CHECK(met(Control::stresses(in_space(1, 2)), in_space(1, 2), in_space(3, 4)));
}
