// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/control/control_solver.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace triax::sim;

namespace {

class Dice {
 public:
  double operator()() { return normal_(engine_); }
  template <class Space>
  Vector<Space> vector() {
    return Vector<Space>::NullaryExpr([this] { return (*this)(); });
  }
  template <class Space>
  Matrix<Space> matrix() {
    return Matrix<Space>::NullaryExpr([this] { return (*this)(); });
  }

 private:
  std::mt19937 engine_{7};
  std::normal_distribution<double> normal_;
};

template <class Space>
Response<Space> norm_form(const Matrix<Space>& stiffness, const Vector<Space>& norm_term) {
  Response<Space> response;
  StiffnessForm<Space>& form = stiffness_form(response);
  form.stiffness = stiffness;
  form.nonlinear = true;
  form.norm_term = norm_term;
  return response;
}

/// A hypoplastic response with |C⁻¹N| of that size, and stiffness in Pa.
template <class Space>
Response<Space> any_norm_form(Dice& dice, double size) {
  const Matrix<Space> a = dice.matrix<Space>();
  const Matrix<Space> c = 1e7 * (a * a.transpose() + Matrix<Space>::Identity());
  return norm_form<Space>(c, size * (c * dice.vector<Space>().normalized()));
}

template <class Space>
MixedControl<Space> any_control(Dice& dice) {
  MixedControl<Space> c;
  c.stress = dice.matrix<Space>();
  c.strain = 1e7 * dice.matrix<Space>();
  c.increment = 1e3 * dice.vector<Space>();
  return c;
}

template <class Space>
PointRate<Space> solve(const Response<Space>& response, const MixedControl<Space>& c) {
  return solve_control(response, PreparedControl<Space>(c, 1e7), Branch{},
                       Vector<Space>(Vector<Space>::Zero()));
}

}  // namespace

TEMPLATE_TEST_CASE("whatever is solved with a norm term satisfies law and conditions", "",
                   Axisymmetric, Tensor) {
  using V = Vector<TestType>;
  Dice dice;
  int met = 0, lost = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto response = any_norm_form<TestType>(dice, 1.5 * std::abs(dice()));
    const auto& form = std::get<StiffnessForm<TestType>>(response);
    const auto control = any_control<TestType>(dice);
    const auto rate = solve(response, control);
    if (!rate.controllable) {
      ++lost;
      CHECK(rate.limiting_variable >= 0);
      CHECK(rate.limiting_variable < TestType::kSize);
      continue;
    }
    ++met;
    const V law = form.stiffness * rate.strain - form.norm_term * rate.strain.norm();
    CHECK((rate.stress - law).norm() < 1e-9 * rate.stress.norm());
    const V rest = control.stress * law + control.strain * rate.strain - control.increment;
    CHECK(rest.norm() < 1e-7 * control.increment.norm());
    CHECK(rate.determinant > 0);
    // det(S T + E)/det A, with the tangent of this direction.
    const V b = (control.stress * form.stiffness + control.strain)
                    .fullPivLu()
                    .solve(V(control.stress * form.norm_term));
    CHECK(rate.determinant ==
          Approx(1 - b.dot(rate.strain) / rate.strain.norm()).margin(1e-7 * (1 + b.norm())));
  }
  CHECK(met > 500);
  CHECK(lost > 100);
}

TEST_CASE("of two solutions the smaller is taken, and none is missed") {
  // In the plane every direction of strain can be tried: with A x = dy, X (d − b) = x.
  Dice dice;
  int twice = 0, never = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto response = any_norm_form<Axisymmetric>(dice, 1.5 * std::abs(dice()));
    const auto& form = std::get<StiffnessForm<Axisymmetric>>(response);
    const auto control = any_control<Axisymmetric>(dice);
    const auto rate = solve(response, control);
    const auto lu = Eigen::Matrix2d(control.stress * form.stiffness + control.strain).fullPivLu();
    const Eigen::Vector2d b = lu.solve(Eigen::Vector2d(control.stress * form.norm_term));
    const Eigen::Vector2d x = lu.solve(control.increment);
    double smallest = -1, before = 0;
    int solutions = 0;
    constexpr int kTurns = 20000;
    for (int k = 0; k <= kTurns; ++k) {
      const double angle = 2 * std::numbers::pi * k / kTurns;
      const Eigen::Vector2d v = Eigen::Vector2d(std::cos(angle), std::sin(angle)) - b;
      const double across = v(0) * x(1) - v(1) * x(0);
      if (k > 0 && across * before <= 0 && v.dot(x) > 0) {
        ++solutions;
        const double length = x.norm() / v.norm();
        if (smallest < 0 || length < smallest) smallest = length;
      }
      before = across;
    }
    if (solutions == 0) {
      ++never;
      CHECK_FALSE(rate.controllable);
    } else if (std::abs(rate.determinant) > 0.05) {
      REQUIRE(rate.controllable);
      CHECK(rate.strain.norm() == Approx(smallest).epsilon(0.02));
      if (solutions == 2) ++twice;
    }
  }
  CHECK(twice > 20);
  CHECK(never > 50);
}

TEST_CASE(
    "of conditions out of reach the limiting_variable is the one that its direction is short of") {
  // dσ = C dε − N |dε| with C = 1 and N along (1, 1): stress cannot rise along N. Asked for mostly
  // by the second row.
  const auto response = norm_form<Axisymmetric>(Matrix<Axisymmetric>::Identity(), {1.2, 1.2});
  MixedControl<Axisymmetric> c = MixedControl<Axisymmetric>::stresses({0.1, 1});
  auto rate = solve(response, c);
  CHECK_FALSE(rate.controllable);
  CHECK(rate.limiting_variable == 1);
  c.increment = {1, 0.1};
  CHECK(solve(response, c).limiting_variable == 0);
  c.increment = {-1, -1};
  rate = solve(response, c);
  REQUIRE(rate.controllable);
  CHECK(rate.strain(0) == Approx(-1 / (1 + 1.2 * std::sqrt(2.0))));
}
