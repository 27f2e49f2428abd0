// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mechanics/space.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "tests/sim/materials/random_tensors.hpp"

using namespace triax::sim;

TEST_CASE("components of a tensor keep the double contraction, the square and the trace") {
  test::RandomTensors random;
  for (int i = 0; i < 50; ++i) {
    const Vector<Tensor> a = random.direction<Tensor>(), b = random.direction<Tensor>();
    const Eigen::Matrix3d m = matrix_of(a), n = matrix_of(b);
    CHECK(components(m).isApprox(a, 1e-14));
    CHECK(a.dot(b) == Approx((m * n).trace()).margin(1e-14));
    CHECK(square<Tensor>(a).isApprox(components(Eigen::Matrix3d(m * m)), 1e-13));
    CHECK(trace<Tensor>(a) == Approx(m.trace()).margin(1e-15));
    CHECK(trace<Tensor>(deviator<Tensor>(a)) == Approx(0).margin(1e-14));
  }
}

TEST_CASE("turned axes turn the components, and keep lengths") {
  test::RandomTensors random;
  const Eigen::Matrix3d q =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const Matrix<Tensor> turn = rotation(q);
  CHECK((turn * turn.transpose()).isApprox(Matrix<Tensor>::Identity(), 1e-14));
  const Vector<Tensor> a = random.direction<Tensor>();
  CHECK((turn * a).isApprox(components(Eigen::Matrix3d(q * matrix_of(a) * q.transpose())), 1e-13));
}

TEST_CASE("both spaces measure the same triaxial state") {
  const auto two = components(AxisymmetricStress{190e3, 70e3});
  const auto six = as_tensor(two);
  CHECK(mean_stress<Axisymmetric>(two) == Approx(110e3));
  CHECK(deviator_stress<Axisymmetric>(two) == Approx(120e3));
  CHECK(mean_stress<Tensor>(six) == Approx(110e3));
  CHECK(deviator_stress<Tensor>(six) == Approx(120e3));
  CHECK(two.norm() == Approx(six.norm()));
  CHECK(as_tensor(square<Axisymmetric>(two)).isApprox(square<Tensor>(six), 1e-14));
  CHECK(axisymmetric_stress(two).radial == Approx(70e3));
}

TEST_CASE("compressed means every principal value, whatever the axes") {
  CHECK(all_compressed<Axisymmetric>(Vector<Axisymmetric>(2, 1)));
  CHECK_FALSE(all_compressed<Axisymmetric>(Vector<Axisymmetric>(2, -1)));
  const Matrix<Tensor> turn =
      rotation(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix());
  const auto principal = [&turn](double a, double b, double c) {
    return Vector<Tensor>(turn * (Vector<Tensor>() << a, b, c, 0, 0, 0).finished());
  };
  CHECK(all_compressed<Tensor>(principal(3, 2, 0.01)));
  CHECK_FALSE(all_compressed<Tensor>(principal(3, 2, -0.01)));
  CHECK_FALSE(all_compressed<Tensor>(principal(3, -1, -1)));
  CHECK_FALSE(all_compressed<Tensor>(principal(-3, -1, -1)));
}

TEST_CASE("p′, q and ε_v, ε_q are work-conjugate") {
  test::RandomTensors random;
  for (int i = 0; i < 20; ++i) {
    const auto s = random.direction<Axisymmetric>(), e = random.direction<Axisymmetric>();
    const auto strain = axisymmetric_strain(e);
    CHECK(s.dot(e) == Approx(mean_stress<Axisymmetric>(s) * volumetric_strain(strain) +
                             deviator_stress<Axisymmetric>(s) * shear_strain(strain))
                          .margin(1e-14));
  }
}
