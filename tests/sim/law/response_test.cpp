// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/law/response.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/materials/random_tensors.hpp"

using namespace triax::sim;

TEST_CASE("plastic mechanisms couple by n_k·C r_j, with the modulus on the diagonal") {
  test::RandomTensors random;
  Response<Tensor> response;
  auto& form = stiffness_form(response);
  form.stiffness = isotropic_stiffness<Tensor>(50e6, 20e6);
  const auto r0 = random.direction<Tensor>(), n0 = random.direction<Tensor>();
  const auto r1 = random.direction<Tensor>(), n1 = random.direction<Tensor>();
  form.add_plastic(r0, n0, 3e6);
  form.add_plastic(isotropic_product<Tensor>(50e6, 20e6, r1),
                   isotropic_product<Tensor>(50e6, 20e6, n1), n1, 5e6);
  REQUIRE(form.mechanisms == 2);
  CHECK(form.hardening(0, 0) == Approx(3e6 + n0.dot(form.stiffness * r0)));
  CHECK(form.hardening(1, 1) == Approx(5e6 + n1.dot(form.stiffness * r1)));
  CHECK(form.hardening(0, 1) == Approx(n0.dot(form.stiffness * r1)));
  CHECK(form.hardening(1, 0) == Approx(n1.dot(form.stiffness * r0)));
  CHECK(form.trigger[1].isApprox(form.stiffness * n1, 1e-12));
  stiffness_form(response).memory_slope[0].setZero(3);
  CHECK(stiffness_form(response).mechanisms == 0);
  CHECK(form.memory_slope[0].size() == 0);
}

TEST_CASE("isotropic elasticity is 3K for a pressure and 2G for a deviator, in both spaces") {
  const auto six = isotropic_stiffness<Tensor>(50e6, 20e6);
  const auto two = isotropic_stiffness<Axisymmetric>(50e6, 20e6);
  CHECK((six * identity<Tensor>()).isApprox(150e6 * identity<Tensor>(), 1e-14));
  CHECK((two * identity<Axisymmetric>()).isApprox(150e6 * identity<Axisymmetric>(), 1e-14));
  const Vector<Axisymmetric> s = deviator<Axisymmetric>(Vector<Axisymmetric>(3, -1));
  CHECK((two * s).isApprox(40e6 * s, 1e-14));
  CHECK((six * as_tensor(s)).isApprox(40e6 * as_tensor(s), 1e-14));
}
