// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/condition_text.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;
using Catch::Contains;
using triax::sim::Axisymmetric;
using triax::sim::Tensor;

namespace {

/// What the condition's left side is of these increments (Pa, plain).
double left(const std::string& text, triax::sim::AxisymmetricStress stress,
            triax::sim::AxisymmetricStrain strain) {
  const auto c = read_condition<Axisymmetric>(text).left;
  return c.stress.transpose().dot(components(stress)) +
         c.strain.transpose().dot(components(strain));
}

double left_of_tensor(const std::string& text, const Eigen::Matrix3d& stress,
                      const Eigen::Matrix3d& strain) {
  const auto c = read_condition<Tensor>(text).left;
  return c.stress.transpose().dot(triax::sim::components(stress)) +
         c.strain.transpose().dot(triax::sim::components(strain));
}

void condition_refused(const std::string& text, const std::string& because) {
  INFO(text);
  CHECK_THROWS_WITH(read_condition<Axisymmetric>(text), Contains(because));
}

}  // namespace

TEST_CASE("every name of the triaxial frames means what it says") {
  const triax::sim::AxisymmetricStress s{90e3, 30e3};
  const triax::sim::AxisymmetricStrain e{0.05, -0.02};
  CHECK(left("axial_strain = 0", s, e) == Approx(0.05));
  CHECK(left("radial_strain = 0", s, e) == Approx(-0.02));
  CHECK(left("volumetric_strain = 0", s, e) == Approx(0.01));
  CHECK(left("shear_strain = 0", s, e) == Approx(2 * 0.07 / 3));
  CHECK(left("shear_strain_pct = 0", s, e) == Approx(200 * 0.07 / 3));
  CHECK(left("sqrt2_radial_strain = 0", s, e) == Approx(-0.02 * std::sqrt(2.0)));
  CHECK(left("p_kPa = 0", s, e) == Approx(50));
  CHECK(left("q_kPa = 0", s, e) == Approx(60));
  CHECK(left("axial_stress_kPa = 0", s, e) == Approx(90));
  CHECK(left("radial_stress_kPa = 0", s, e) == Approx(30));
  CHECK(left("sqrt2_radial_stress_kPa = 0", s, e) == Approx(30 * std::sqrt(2.0)));
}

TEST_CASE("combinations, signs, stars and blanks") {
  const triax::sim::AxisymmetricStress s{90e3, 30e3};
  const triax::sim::AxisymmetricStrain e{0.05, -0.02};
  CHECK(left("q_kPa - 3 p_kPa = 0", s, e) == Approx(-90));
  CHECK(left(" -2*axial_strain+1.5e1   radial_strain=0 ", s, e) == Approx(-0.4));
  CHECK(left("+ q_kPa + 1e3 axial_strain = 0", s, e) == Approx(110));
  const auto condition =
      read_condition<Axisymmetric>("axial_strain  + 1.65 radial_strain = -.5e-2");
  CHECK(condition.label == "axial_strain + 1.65 radial_strain");
  CHECK(condition.total == -0.005);
  CHECK(read_condition<Axisymmetric>("q_kPa = +60").total == 60);
}

TEST_CASE("components of a tensor, and triaxial names of one") {
  Eigen::Matrix3d s, e;
  s << 90e3, 4e3, 5e3, 4e3, 20e3, 6e3, 5e3, 6e3, 40e3;
  e << 0.05, 0.01, 0.02, 0.01, -0.01, 0.03, 0.02, 0.03, -0.03;
  CHECK(left_of_tensor("stress_12_kPa = 0", s, e) == Approx(4));
  CHECK(left_of_tensor("stress_23_kPa = 0", s, e) == Approx(6));
  CHECK(left_of_tensor("stress_33_kPa = 0", s, e) == Approx(40));
  CHECK(left_of_tensor("strain_13 = 0", s, e) == Approx(0.02));
  CHECK(left_of_tensor("strain_22_pct = 0", s, e) == Approx(-1));
  CHECK(left_of_tensor("volumetric_strain = 0", s, e) == Approx(0.01));
  CHECK(left_of_tensor("q_kPa = 0", s, e) == Approx(60));
  CHECK(increment_names<Tensor>().size() > increment_names<Axisymmetric>().size());
  for (const auto& name : increment_names<Tensor>())
    CHECK_NOTHROW(read_condition<Tensor>(name + " = 0.1"));
}

TEST_CASE("what is no condition is refused with its column and what is known") {
  condition_refused("", "column 1: expected the name of an increment, found the end");
  condition_refused("axial_strian = 0.1",
                    "column 1: unknown increment 'axial_strian'; did you mean "
                    "'axial_strain'?");
  condition_refused("q_kPa + pp_kPa = 1", "column 9");
  condition_refused("q = 1", "'q'");
  condition_refused("axial_strain", "expected '= TOTAL'");
  condition_refused("axial_strain 0.1", "column 14");
  condition_refused("axial_strain = ", "total increment");
  condition_refused("axial_strain = abc", "column 16");
  condition_refused("q_kPa = 10 kPa", "the unit is part of the name");
  condition_refused("q_kPa = 1e400", "out of range");
  condition_refused("q_kPa = nan", "total increment");
  condition_refused("0 q_kPa = 1", "the coefficient 0");
  condition_refused("1e30 q_kPa = 1", "the coefficient");
  condition_refused("q_kPa - q_kPa = 1", "the condition is empty");
  condition_refused("q_kPa = 1e9", "out of range");
  condition_refused("axial_strain = 10", "out of range");
  condition_refused("stress_11_kPa = 1", "unknown increment");
  condition_refused("q_kPa == 1", "total increment");
  condition_refused("q_kPa_pct = 1", "unknown increment");
  CHECK_THROWS_WITH(read_combination<Axisymmetric>("q_kPa = 1"), Contains("column 7"));
  CHECK_THROWS_WITH(check_total(read_combination<Axisymmetric>("q_kPa"), 1e9),
                    Contains("out of range"));
}
