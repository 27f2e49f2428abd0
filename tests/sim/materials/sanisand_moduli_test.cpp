#include "sim/materials/sanisand_moduli.hpp"

#include <catch2/catch.hpp>

#include "sim/point/point_driver.hpp"
#include "tests/sim/materials/interpolated_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;
using Control = MixedControl<Axisymmetric>;
using State = PointState<Axisymmetric>;

TEST_CASE("INL2's matrices at p = 70 kPa, eta = 0.55, e = 1.086 are those of the reference") {
  const auto material = law<Tensor>(Interpolation::inl2, kInl2);
  const auto s = material.start(
      as_tensor(components(AxisymmetricStress{70e3 * (1 + 1.1 / 3), 70e3 * (1 - 0.55 / 3)})),
      1.086);
  const auto n = std::get<InterpolatedForm<Tensor>>(material.response(s));
  const auto column = [](const Matrix<Tensor>& m, int j) {
    return Eigen::Vector3d(m.col(j).head<3>() * 1e9);  // 1e-6/kPa
  };
  CHECK(column(n.plus, 0).isApprox(Eigen::Vector3d(189.576, -23.455, -23.455), 2e-5));
  CHECK(column(n.plus, 1).isApprox(Eigen::Vector3d(-5.321, 53.214, -5.321), 2e-5));
  CHECK(column(n.minus, 0).isApprox(Eigen::Vector3d(53.214, -5.321, -5.321), 2e-5));
  CHECK(column(n.minus, 2).isApprox(Eigen::Vector3d(-119.420, 9.851, 68.387), 2e-5));
}

TEST_CASE("a reversal of the stress ratio is remembered") {
  const auto material = inl2();
  const State loaded =
      advance_point(material, material.isotropic(100e3, 1.0), Control::stress_path(0, 40e3)).state;
  const State back = advance_point(material, loaded, Control::stress_path(0, -10e3)).state;
  const Vector<Axisymmetric> alpha_in = back.memory.head<2>();
  CHECK(deviator_stress<Axisymmetric>(alpha_in) == Approx(0.4 - 0.01).epsilon(1e-9));
  CHECK(back.memory(2) == -1);
  // Just after the reversal loading is as stiff as elasticity.
  const auto up = moduli(material, advance_point(material, back, Control::stress_path(0, 1)).state);
  CHECK(up.plus(0, 0) == Approx(up.minus(0, 0)).epsilon(1e-3));
}
