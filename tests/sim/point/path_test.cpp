// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/path.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "tests/sim/point/triaxial_segment.hpp"

using namespace triax::sim;
using triax::sim::test::kRadial;

namespace {

Segment<Axisymmetric> undrained(double axial_strain, double radial_stress) {
  Segment<Axisymmetric> s;
  s.labels = {"axial_strain", "radial_stress_kPa"};
  s.conditions.strain.row(0) << 1, 0;
  s.conditions.stress.row(1) << 0, kRadial;
  s.conditions.increment << axial_strain, radial_stress;
  s.undrained = true;
  return s;
}

}  // namespace

TEST_CASE("an undrained segment trades one condition on total stress for constant volume") {
  const auto effective = effective_control(undrained(0.1, 5e3));
  CHECK(effective.control.stress.isZero(0));
  CHECK(effective.control.strain.row(0).isApprox(Eigen::RowVector2d(1, 0)));
  CHECK(effective.control.strain.row(1).isApprox(identity<Axisymmetric>().transpose()));
  CHECK(effective.control.increment(1) == 0);
  CHECK(effective.labels[0] == "axial_strain");
  // du = dσ₃ − dσ₃′
  CHECK(effective.pore_pressure_change(1, components(AxisymmetricStress{40e3, -7e3}),
                                       Vector<Axisymmetric>::Zero()) == Approx(12e3));
  CHECK(effective.pore_pressure_change(0.5, components(AxisymmetricStress{40e3, -7e3}),
                                       Vector<Axisymmetric>::Zero()) == Approx(9.5e3));
}

TEST_CASE("of two total stresses the one that is held is given up, and the other becomes q") {
  Segment<Axisymmetric> s;
  s.labels = {"axial_stress_kPa", "radial_stress_kPa"};
  s.conditions.stress << 1, 0, 0, kRadial;
  s.conditions.increment << 30e3, 0;
  s.undrained = true;
  const auto effective = effective_control(s);
  CHECK(effective.labels[0] == "axial_stress_kPa");
  CHECK(effective.control.stress.row(0).isApprox(Eigen::RowVector2d(1, -kRadial)));
  CHECK(effective.control.increment(0) == 30e3);
}

TEST_CASE("a segment without a total stress, and conditions that repeat each other, are refused") {
  auto s = undrained(0.1, 0);
  s.conditions.stress.row(1) << 1, -kRadial;  // q says nothing of the pore pressure
  CHECK_THROWS_WITH(effective_control(s), Catch::Contains("one condition on a total stress"));

  auto twice = undrained(0.1, 0);
  twice.undrained = false;
  twice.conditions.stress.row(1).setZero();
  twice.conditions.strain.row(1) << 3, 0;
  CHECK_THROWS_WITH(effective_control(twice), Catch::Contains("radial_stress_kPa"));

  auto volume = undrained(0, 0);
  volume.conditions.strain.row(0) = identity<Axisymmetric>().transpose();
  CHECK_THROWS_WITH(effective_control(volume), Catch::Contains("undrained implies"));
}

TEST_CASE("the conditions of a triaxial segment on a tensor") {
  const auto lifted = as_tensor_segment(undrained(0.1, 5e3));
  REQUIRE(lifted.labels.size() == 6);
  const auto effective = effective_control(lifted);
  CHECK(effective.undrained);
  CHECK(effective.control.strain.row(2).isApprox(
      (Eigen::Matrix<double, 1, 6>() << 0, 1, -1, 0, 0, 0).finished()));
  const auto stress = as_tensor(components(AxisymmetricStress{40e3, -7e3}));
  CHECK(effective.pore_pressure_change(1, stress, Vector<Tensor>::Zero()) == Approx(12e3));
}

TEST_CASE("repetitions are written out, also one within another") {
  Path<Axisymmetric> path;
  path.segments.resize(3);
  path.segments[1].repeat = 2;
  path.segments[2].repeat = 2;
  path.segments[2].repeat_from = 0;
  CHECK(segment_order(path) == std::vector<std::size_t>{0, 1, 1, 2, 0, 1, 1, 2});
  path.segments[1].repeat = 2'000'000;
  CHECK_THROWS_AS(segment_order(path), std::invalid_argument);
}
