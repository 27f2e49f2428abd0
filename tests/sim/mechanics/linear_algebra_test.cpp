// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mechanics/linear_algebra.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

using namespace triax::sim;

namespace {

/// 2 on the diagonal, −1 beside it: determinant n + 1, eigenvectors sin(k i π/(n + 1)).
template <class Space>
Matrix<Space> chain() {
  Matrix<Space> a = Matrix<Space>::Zero();
  a.diagonal().setConstant(2);
  for (int i = 1; i < Space::kSize; ++i) a(i, i - 1) = a(i - 1, i) = -1;
  return a;
}

/// Two equal rows.
template <class Space>
Matrix<Space> singular() {
  Matrix<Space> a = chain<Space>();
  a.row(1) = a.row(0);
  return a;
}

}  // namespace

TEMPLATE_TEST_CASE("systems of a space are solved as the chain's closed forms say",
                   "[linear_algebra]", Axisymmetric, Tensor) {
  constexpr int n = TestType::kSize;
  const Matrix<TestType> a = chain<TestType>();
  Vector<TestType> x;
  for (int i = 0; i < n; ++i) x(i) = i + 1;
  const Vector<TestType> b = a * x;  // 0 but for the last, n + 1
  CHECK(b(n - 1) == n + 1);
  CHECK((solve<TestType>(a, b) - x).norm() < 1e-13);
  CHECK((Factors<TestType>(a).solve(b) - x).norm() < 1e-13);
  CHECK((*solve_regular<TestType>(a, b) - x).norm() < 1e-13);
  CHECK(determinant<TestType>(a) == Approx(n + 1).epsilon(1e-14));
  CHECK(Factors<TestType>(a).determinant() == Approx(n + 1).epsilon(1e-14));

  const double corner = 1.0 / (n + 1);  // of the inverse: min(i, j) (n + 1 − max(i, j))/(n + 1)
  CHECK(inverse<TestType>(a)(0, n - 1) == Approx(corner).epsilon(1e-13));
  CHECK((*regular_inverse<TestType>(a))(0, n - 1) == Approx(corner).epsilon(1e-13));

  const Eigen::VectorXd least = least_eigenvector(a);
  CHECK(least.norm() == Approx(1));
  const double wave =
      std::sin(std::numbers::pi / (n + 1)) / std::sin(2 * std::numbers::pi / (n + 1));
  CHECK(least(0) / least(1) == Approx(wave).epsilon(1e-12));
}

TEMPLATE_TEST_CASE("a singular system has no regular solution and no regular inverse",
                   "[linear_algebra]", Axisymmetric, Tensor) {
  const Matrix<TestType> a = singular<TestType>();
  CHECK(determinant<TestType>(a) == 0);
  CHECK_FALSE(solve_regular<TestType>(a, Vector<TestType>::Ones()));
  CHECK_FALSE(regular_inverse<TestType>(a));
  Matrix<TestType> unknown = chain<TestType>();
  unknown(0, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(regular_inverse<TestType>(unknown));
}

TEST_CASE("principal values and axes are those of a turned diagonal", "[linear_algebra]") {
  const Eigen::Matrix3d turn(Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()));
  const Eigen::Vector3d values(-1, 2, 5);
  const PrincipalAxes found = principal_axes(turn * values.asDiagonal() * turn.transpose());
  CHECK((found.values - values).norm() < 1e-14);
  for (int i = 0; i < 3; ++i)
    CHECK(std::abs(found.directions.col(i).dot(turn.col(i))) == Approx(1).epsilon(1e-14));
}
