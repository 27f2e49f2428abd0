#include "sim/point/mixed_control.hpp"

#include <catch2/catch.hpp>

using triax::sim::MixedControl;

TEST_CASE("named paths say what their names promise") {
  const Eigen::Vector2d isochoric(0.02, -0.01);
  const auto undrained = MixedControl::strain_path(0.02);
  CHECK((undrained.strain * isochoric - undrained.increment).norm() == Approx(0).margin(1e-15));
  CHECK(undrained.stress.isZero());

  const Eigen::Vector2d stress(5 + 2.0 / 3 * 9, 5 - 9.0 / 3);  // of p = 5, q = 9
  const auto path = MixedControl::stress_path(5, 9);
  CHECK((path.stress * stress - path.increment).norm() == Approx(0).margin(1e-14));

  const auto drained = MixedControl::drained_compression(0.02);
  CHECK(drained.increment == Eigen::Vector2d(0.02, 0));
  CHECK(drained.stress.row(1) == Eigen::RowVector2d(0, 1));
}
