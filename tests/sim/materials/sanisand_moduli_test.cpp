// SPDX-License-Identifier: GPL-3.0-or-later
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

namespace {

// Of the memory: α at the last reversal, α at the turning point, the direction, whether turning.
Vector<Axisymmetric> alpha_in(const State& s) { return s.memory.head<2>(); }
double rising(const State& s) { return s.memory(4); }
bool turning(const State& s) { return s.memory(5) != 0; }

State moved(const Law<Axisymmetric>& material, const State& from, double dp, double dq) {
  const auto step = advance_point(material, from, Control::stress_path(dp, dq));
  REQUIRE(step.outcome == StepOutcome::accepted);
  return step.state;
}

/// η at which the volume stops swelling (W2 vanishes) at constant q and falling p′, in steps of
/// 50 Pa; on each q goes off by `wobble` and back.
double constant_shear_collapse(const Law<Axisymmetric>& material, double wobble) {
  const double q = 90e3;
  State s = moved(material, material.isotropic(300e3, 1.161), q / 3, q);
  const Control falling = Control::stress_path(-1, 0);
  while (trace<Axisymmetric>(point_rate(material, s, falling).strain) < 0) {
    if (wobble != 0) s = moved(material, moved(material, s, 0, wobble), 0, -wobble);
    s = moved(material, s, -50, 0);
    REQUIRE(s.p() > 100e3);
  }
  return s.q() / s.p();
}

}  // namespace

TEST_CASE("a reversal of the stress ratio is remembered") {
  const auto material = inl2();
  const double range = 2 * s28_general().yield_radius;
  const State loaded = moved(material, material.isotropic(100e3, 1.0), 0, 40e3);
  const State back = moved(material, loaded, 0, -2 * range * 100e3);
  CHECK(deviator_stress<Axisymmetric>(alpha_in(back)) == Approx(0.4 - range / 2).epsilon(1e-9));
  CHECK(rising(back) == -1);
  CHECK_FALSE(turning(back));
  // Once a way up is a reversal in its turn loading is stiff again, much stiffer than before.
  const State up = moved(material, back, 0, 1.01 * range * 100e3);
  CHECK(rising(up) == 1);
  const auto fresh = moduli(material, up), spent = moduli(material, loaded);
  CHECK(fresh.plus(0, 0) / fresh.minus(0, 0) < 1.2);
  CHECK(spent.plus(0, 0) / spent.minus(0, 0) > 2);
}

TEST_CASE("what goes back by less than the elastic range is no reversal") {
  const auto material = inl2();
  const double range = 2 * s28_general().yield_radius;
  const State loaded = moved(material, material.isotropic(100e3, 1.0), 0, 40e3);
  const State back = moved(material, loaded, 0, -0.9 * range * 100e3);
  CHECK(alpha_in(back) == alpha_in(loaded));
  CHECK(rising(back) == 1);
  CHECK(turning(back));
  const State again = moved(material, back, 0, 0.9 * range * 100e3 + 100);
  const State without = moved(material, loaded, 0, 100);
  CHECK_FALSE(turning(moved(material, again, 0, 1)));
  CHECK(moduli(material, again).plus.isApprox(moduli(material, without).plus, 1e-3));
}

TEST_CASE("a wobble of 10 Pa in q does not move the end of a constant-q path") {
  const auto material = inl2();
  const double plain = constant_shear_collapse(material, 0);
  CHECK(plain == Approx(0.545).margin(0.003));
  CHECK(constant_shear_collapse(material, 10) == Approx(plain).margin(0.001));
  CHECK(constant_shear_collapse(material, -10) == Approx(plain).margin(0.001));
}

TEST_CASE("a reversal is noted at the same place however the path is cut") {
  const auto material = inl2();
  const State loaded = moved(material, material.isotropic(100e3, 1.0), 0, 40e3);
  const auto there_and_up = [&](int cuts) {
    State s = loaded;
    for (int i = 0; i < cuts; ++i) s = moved(material, s, 0, -10e3 / cuts);
    for (int i = 0; i < cuts; ++i) s = moved(material, s, 0, 20e3 / cuts);
    return s;
  };
  const State whole = there_and_up(1);
  REQUIRE(rising(whole) == 1);
  CHECK(deviator_stress<Axisymmetric>(alpha_in(whole)) ==
        Approx(0.3 - s28_general().yield_radius).epsilon(1e-9));
  for (const int cuts : {3, 7, 64, 501}) {
    INFO(cuts << " parts");
    const State cut = there_and_up(cuts);
    CHECK(alpha_in(cut).isApprox(alpha_in(whole), 1e-9));
    CHECK(cut.void_ratio == Approx(whole.void_ratio).epsilon(1e-9));
  }
}
