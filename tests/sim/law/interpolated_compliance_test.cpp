// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/law/interpolated_compliance.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/materials/random_tensors.hpp"

using namespace triax::sim;

namespace {

template <class Space>
InterpolatedForm<Space> random_form(test::RandomTensors& random, bool quadratic) {
  InterpolatedForm<Space> form;
  for (int j = 0; j < Space::kSize; ++j) {
    form.plus.col(j) = random.direction<Space>();
    form.minus.col(j) = j < kPrincipalAxes<Space> ? random.direction<Space>() : form.plus.col(j);
  }
  form.quadratic = quadratic;
  return form;
}

template <class Space>
void check_derivatives(bool quadratic) {
  test::RandomTensors random;
  for (int i = 0; i < 50; ++i) {
    const InterpolatedCompliance<Space> law(random_form<Space>(random, quadratic));
    const Vector<Space> v = 3 * random.direction<Space>();
    const Matrix<Space> tangent = law.tangent(v);
    CHECK((tangent * v - law.strain(v)).norm() < 1e-13);
    CHECK((law.secant(v) * v - law.strain(v)).norm() < 1e-13);
    CHECK((law.strain(7 * v) - 7 * law.strain(v)).norm() < 1e-12);
    for (int j = 0; j < Space::kSize; ++j) {
      const Vector<Space> aside = 1e-6 * Vector<Space>::Unit(j);
      const Vector<Space> slope = (law.strain(v + aside) - law.strain(v - aside)) / 2e-6;
      CHECK((tangent.col(j) - slope).norm() < 1e-7);
    }
  }
}

}  // namespace

TEST_CASE("the interpolated compliance: homogeneous, tangent and secant give the strain back") {
  for (const bool quadratic : {true, false}) {
    check_derivatives<Axisymmetric>(quadratic);
    check_derivatives<Tensor>(quadratic);
  }
}

TEST_CASE("on the axes the interpolated compliance is N+ and N-, and linear where they agree") {
  test::RandomTensors random;
  auto form = random_form<Tensor>(random, true);
  const InterpolatedCompliance<Tensor> law(form);
  for (int j = 0; j < 3; ++j) {
    CHECK((law.strain(Vector<Tensor>::Unit(j)) - form.plus.col(j)).norm() < 1e-15);
    CHECK((law.strain(-Vector<Tensor>::Unit(j)) + form.minus.col(j)).norm() < 1e-15);
  }
  form.minus = form.plus;
  const Vector<Tensor> v = random.direction<Tensor>();
  CHECK((InterpolatedCompliance<Tensor>(form).strain(v) - form.plus * v).norm() < 1e-15);
}
