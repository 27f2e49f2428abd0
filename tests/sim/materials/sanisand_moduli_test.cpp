// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/sanisand_moduli.hpp"

#include <catch2/catch.hpp>
#include <numbers>
#include <vector>

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

// Of the memory: α at the last reversal, r at the turning point, α of three reversals before, the
// number of loadings interrupted, whether turning.
Vector<Axisymmetric> alpha_in(const State& s) { return s.memory.head<2>(); }
double interrupted(const State& s) { return s.memory(10); }
bool turning(const State& s) { return s.memory(11) != 0; }

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
  CHECK(interrupted(back) == 1);
  CHECK_FALSE(turning(back));
  // Once a way up is a reversal in its turn loading is stiff again, much stiffer than before.
  const State up = moved(material, back, 0, 1.01 * range * 100e3);
  CHECK(interrupted(up) == 2);
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
  CHECK(interrupted(back) == 0);
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
    for (int i = 0; i < cuts; ++i) s = moved(material, s, 0, 9e3 / cuts);
    return s;
  };
  const State whole = there_and_up(1);
  REQUIRE(interrupted(whole) == 2);
  CHECK(deviator_stress<Axisymmetric>(alpha_in(whole)) ==
        Approx(0.3 + s28_general().yield_radius).epsilon(1e-9));
  for (const int cuts : {3, 7, 64, 501}) {
    INFO(cuts << " parts");
    const State cut = there_and_up(cuts);
    CHECK(alpha_in(cut).isApprox(alpha_in(whole), 1e-9));
    CHECK(cut.void_ratio == Approx(whole.void_ratio).epsilon(1e-8));
  }
}

namespace {

/// Shear strain per stress at constant p′, 1/Pa.
double shear_compliance(const Law<Axisymmetric>& material, const State& s, double sign) {
  const auto rate = point_rate(material, s, Control::stress_path(0, sign * 1e3));
  REQUIRE(rate.controllable);
  return (rate.strain(0) - rate.strain(1) / std::numbers::sqrt2) / (sign * 1e3);
}

State along(const Law<Axisymmetric>& material, State s, std::initializer_list<double> q_kPa) {
  for (const double q : q_kPa) s = moved(material, s, 0, 1e3 * q - s.q());
  return s;
}

/// Oedometric: axial stress to this, radial strain held.
PointStep<Axisymmetric> oedometric(const Law<Axisymmetric>& material, const State& s,
                                   double axial_kPa) {
  Control c;
  c.stress << 1, 0, 0, 0;
  c.strain << 0, 0, 0, 1;
  c.increment << 1e3 * axial_kPa - s.stress(0), 0;
  return advance_point(material, s, c, {.relative = 1e-8, .step_limit = 3000});
}

}  // namespace

TEST_CASE("a loop that closes is forgotten: loading goes on as without it") {
  for (const auto& material : {inl2(), octo()}) {
    const State start = material.isotropic(100e3, 1.0);
    const State plain = along(material, start, {45});
    for (const auto& ways : {std::initializer_list<double>{40, 33, 45},
                             {40, 30, 38, 32, 45},
                             {40, -20, 45},
                             {40, 30, 38, 32, 37, 33, 36.2, 33.5, 45},
                             {30, 25, 35, 31, 45}}) {
      const State s = along(material, start, ways);
      CHECK(interrupted(s) == 0);
      CHECK(alpha_in(s).isZero(0));
      // But for the void ratio, which the loop has changed a little.
      CHECK(shear_compliance(material, s, 1) ==
            Approx(shear_compliance(material, plain, 1)).epsilon(0.03));
    }
    // An open loop is stiff, and closes to the bit where the loading was left.
    const State inside = along(material, start, {40, 33, 37});
    CHECK(interrupted(inside) == 2);
    CHECK(shear_compliance(material, inside, 1) <
          0.8 * shear_compliance(material, along(material, start, {37}), 1));
    const State before = along(material, start, {40, 33, 39.99}),
                after = along(material, start, {40, 33, 40.01});
    CHECK(interrupted(before) == 2);
    CHECK(interrupted(after) == 0);
  }
}

TEST_CASE("wobbles on the way up do not raise the undrained peak") {
  for (const auto& material : {inl2(), octo()}) {
    const auto peak = [&material](bool wobbling) {
      State s = material.isotropic(100e3, 1.11);
      double largest = 0, next = 5e3;
      const auto strained = [&](double strain) {
        s = advance_point(material, s, Control::strain_path(strain)).state;
        largest = std::max(largest, s.q());
      };
      for (int i = 0; i < 400; ++i) {
        strained(2e-5);
        if (!wobbling || s.q() < next) continue;
        next = s.q() + 5e3;
        for (double down = 4e3; down > 1e3; down /= 1.5) {  // a load that rings
          const double top = s.q();
          while (s.q() > top - down) strained(-1e-6);
          while (s.q() < top - 0.2 * down) strained(1e-6);
        }
      }
      return largest;
    };
    const double plain = peak(false);
    CHECK(peak(true) < 1.01 * plain);
    CHECK(peak(true) > 0.9 * plain);
  }
}

TEST_CASE("oedometric unloading: K rises and the specimen swells, to the end and however cut") {
  for (const auto& material : {inl2(), octo()}) {
    const auto loaded = oedometric(material, material.isotropic(100e3, 0.85), 1000);
    REQUIRE(loaded.outcome == StepOutcome::accepted);
    REQUIRE(loaded.state.q() > 300e3);
    State s = loaded.state;
    double k = 0, e = 0;
    for (double axial = 980; axial >= 20; axial -= 20) {
      const auto step = oedometric(material, s, axial);
      INFO("axial stress " << axial << " kPa: " << step.message);
      REQUIRE(step.outcome == StepOutcome::accepted);
      s = step.state;
      const double now = s.stress(1) / std::numbers::sqrt2 / s.stress(0);
      CHECK(now > k);
      CHECK(s.void_ratio > e);
      k = now;
      e = s.void_ratio;
    }
    CHECK(k > 0.8);
    const auto once = oedometric(material, loaded.state, 20);
    REQUIRE(once.outcome == StepOutcome::accepted);
    CHECK(once.state.stress.isApprox(s.stress, 1e-5));
    // SANISAND itself swells as much within a tenth: both unload on its elasticity.
    const Sanisand<Axisymmetric> base(s28_general());
    State b = base.isotropic(100e3, 0.85);
    for (const double axial : {1000.0, 20.0}) {
      if (axial < 100) e = b.void_ratio;
      const auto step = oedometric(base, b, axial);
      REQUIRE(step.outcome == StepOutcome::accepted);
      b = step.state;
    }
    CHECK(s.void_ratio - loaded.state.void_ratio == Approx(b.void_ratio - e).epsilon(0.1));
  }
}

TEST_CASE("undrained unloading goes through q = 0, where nothing happens to it") {
  for (const auto& material : {inl2(), octo()}) {
    State s = along(material, material.isotropic(200e3, 0.85), {100, 20});
    std::vector<double> slope;  // dq/dε₁
    while (s.q() > -20e3) {
      const auto step = advance_point(material, s, Control::strain_path(-2e-5));
      REQUIRE(step.outcome == StepOutcome::accepted);
      slope.push_back((step.state.q() - s.q()) / -2e-5);
      s = step.state;
    }
    REQUIRE(slope.size() > 20);
    for (std::size_t i = 1; i < slope.size(); ++i)
      CHECK(slope[i] == Approx(slope[i - 1]).epsilon(0.05));
  }
}

TEST_CASE("the moduli of a state that goes back through q = 0 are continuous") {
  // Without a difference between compression and extension.
  SanisandParameters p = with_h0(kInl2);
  p.extension_ratio = 1;
  const Interpolated<Axisymmetric> material(Interpolation::inl2,
                                            std::make_shared<SanisandModuli<Axisymmetric>>(p));
  const State start = material.isotropic(100e3, 1.0);
  const auto plus_of = [&](double from, double to) {
    return moduli(material, along(material, start, {from, to}));
  };
  const auto above = plus_of(40, 0.01), below = plus_of(40, -0.01);
  CHECK(above.plus.isApprox(below.plus, 1e-3));
  CHECK(above.minus.isApprox(below.minus, 1e-3));
  // Going on is elastoplastic, going back elastic.
  CHECK(above.minus(0, 0) > 1.5 * above.plus(0, 0));
  const auto other = plus_of(-40, 0);
  CHECK(other.plus(0, 0) > 1.5 * other.minus(0, 0));
}
