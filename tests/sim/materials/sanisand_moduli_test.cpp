// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/sanisand_moduli.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <optional>
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

// Of the memory: η at which it was left and as far as which it came back, of two loops.
double left(const State& s, int loop = 0) { return s.memory(2 * loop); }
double back(const State& s, int loop = 0) { return s.memory(2 * loop + 1); }

State moved(const Law<Axisymmetric>& material, const State& from, double dp, double dq) {
  const auto step = advance_point(material, from, Control::stress_path(dp, dq));
  REQUIRE(step.outcome == StepOutcome::accepted);
  return step.state;
}

State along(const Law<Axisymmetric>& material, State s, std::initializer_list<double> q_kPa) {
  for (const double q : q_kPa) s = moved(material, s, 0, 1e3 * q - s.q());
  return s;
}

/// Shear strain per stress at constant p′, 1/Pa.
double shear_compliance(const Law<Axisymmetric>& material, const State& s, double sign) {
  const auto rate = point_rate(material, s, Control::stress_path(0, sign * 1e3));
  REQUIRE(rate.controllable);
  return (rate.strain(0) - rate.strain(1) / std::numbers::sqrt2) / (sign * 1e3);
}

/// η at which the volume stops swelling (W2 vanishes) at constant q and falling p′, in steps of
/// 50 Pa; on each q goes off by `wobble` and back.
double wobbling_shear_collapse(const Law<Axisymmetric>& material, double wobble) {
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

TEST_CASE("a fall of the stress ratio makes loading stiff until it is where it was left") {
  for (const auto& material : {inl2(), octo()}) {
    const State first = material.isotropic(100e3, 1.0);
    const State inside = along(material, first, {40, 30});
    CHECK(left(inside) == Approx(0.4).epsilon(1e-12));
    CHECK(back(along(material, inside, {31})) == Approx(0.3).epsilon(1e-9));
    const auto softening = [&](double q) {  // N⁺ over N⁻, column of the axial stress
      const auto n = moduli(material, along(material, inside, {q}));
      return n.plus(0, 0) / n.minus(0, 0);
    };
    const auto virgin = moduli(material, along(material, first, {40}));
    CHECK(softening(30.5) < 1.1);
    CHECK(softening(39) > softening(35));
    CHECK(softening(39) < 0.8 * virgin.plus(0, 0) / virgin.minus(0, 0));
    // There the moduli are those of first loading, but for the void ratio, and stay so.
    const State again = along(material, inside, {40.1, 40.2});
    CHECK(left(again) == 0);
    CHECK(moduli(material, along(material, inside, {39.999})).plus.isApprox(virgin.plus, 5e-3));
    CHECK(moduli(material, again)
              .plus.isApprox(moduli(material, along(material, first, {40.2})).plus, 5e-3));
  }
}

TEST_CASE("a loop within a loop is left for the outer one, and that for the loading") {
  for (const auto& material : {inl2(), octo()}) {
    const State first = material.isotropic(100e3, 1.0);
    const State outer = along(material, first, {40, 20, 35});
    const State inner = along(material, outer, {30, 32});
    CHECK(left(inner, 0) == Approx(0.4).epsilon(1e-9));
    CHECK(left(inner, 1) == Approx(0.35).epsilon(1e-9));
    CHECK(back(inner, 1) == Approx(0.30).epsilon(1e-9));
    CHECK(shear_compliance(material, inner, 1) <
          0.97 * shear_compliance(material, along(material, first, {40, 20, 32}), 1));
    const State closed = along(material, inner, {36});
    CHECK(left(closed, 1) == 0);
    CHECK(shear_compliance(material, closed, 1) ==
          Approx(shear_compliance(material, along(material, outer, {36}), 1)).epsilon(0.02));
    // Further back than the outer loop came there is no inner one.
    const State further = along(material, outer, {15, 16});
    CHECK(left(further, 1) == 0);
    CHECK(back(further, 0) == Approx(0.15).epsilon(1e-9));
  }
}

TEST_CASE("a wobble of 10 Pa in q does not move the end of a constant-q path") {
  const auto material = inl2();
  const double plain = wobbling_shear_collapse(material, 0);
  CHECK(plain == Approx(0.545).margin(0.003));
  CHECK(wobbling_shear_collapse(material, 10) == Approx(plain).margin(0.001));
  CHECK(wobbling_shear_collapse(material, -10) == Approx(plain).margin(0.001));
}

TEST_CASE("reversals and q = 0 are met at the same place however the path is cut") {
  for (const auto& material : {inl2(), octo()}) {
    const auto around = [&](int cuts) {
      State s = material.isotropic(100e3, 1.0);
      for (const double dq : {40e3, -75e3, 55e3, -50e3, 40e3, 15e3, -8e3, 4e3})
        for (int i = 0; i < cuts; ++i) s = moved(material, s, 0, dq / cuts);
      return s;
    };
    const State whole = around(1);
    CHECK(left(whole, 0) == Approx(0.4).epsilon(1e-9));
    CHECK(back(whole, 0) == s28_general().yield_radius);
    CHECK(left(whole, 1) == Approx(0.25).epsilon(1e-9));
    CHECK(back(whole, 1) == Approx(0.17).epsilon(1e-9));
    for (const int cuts : {3, 7, 64, 501}) {
      INFO(cuts << " parts");
      const State cut = around(cuts);
      CHECK((cut.memory - whole.memory).head(4).isZero(1e-9));
      CHECK(cut.void_ratio == Approx(whole.void_ratio).epsilon(1e-7));
    }
  }
}

TEST_CASE("what a wobble leaves behind follows its size, without a threshold") {
  for (const auto& material : {inl2(), octo()}) {
    const State start = along(material, material.isotropic(100e3, 1.0), {40});
    const auto shear = [&](double wobble_kPa) {  // from q = 40 to 45 kPa
      State s = start;
      double strain = 0;
      for (const double dq : {-1e3 * wobble_kPa, 1e3 * wobble_kPa, 5e3}) {
        if (dq == 0) continue;
        const auto step = advance_point(material, s, Control::stress_path(0, dq));
        REQUIRE(step.outcome == StepOutcome::accepted);
        s = step.state;
        strain += step.strain_increment(0);
      }
      return strain;
    };
    const double plain = shear(0);
    double before = 0;
    for (const double wobble :
         {1e-4, 1e-3, 0.01, 0.05, 0.1, 0.19, 0.21, 0.5, 1.0, 1.9, 2.1, 5.0, 10.0}) {
      INFO("wobble of " << wobble << " kPa");
      const double more = shear(wobble) / plain - 1;
      CHECK(more > -1e-3);                    // the loop stiffens nothing, but e has changed
      CHECK(more < 0.8 * wobble / 5 + 1e-6);  // and adds less than its own length of loading
      CHECK(std::abs(more - before) < 0.02 + 0.03 * wobble);
      before = more;
    }
  }
}

TEST_CASE("no closed loop of the stress ratio gives work") {
  for (const auto& material : {inl2(), octo()})
    for (const double q : {5.0, 20.0, 50.0, 80.0, -20.0, -50.0})
      for (const double size : {0.01, 0.1, 0.3, 1.0, 4.0, 30.0, 110.0}) {
        if (std::abs(q - size) > 80) continue;
        INFO("from q = " << q << " kPa back by " << size);
        State s = along(material, material.isotropic(100e3, 1.0), {q});
        double work = 0, exchanged = 0;  // Pa
        for (const double dq : {-1.0, 0.7, -0.4, 0.7})
          for (int i = 0; i < 20; ++i) {
            const Vector<Axisymmetric> mean = s.stress;
            const auto step = advance_point(
                material, s, Control::stress_path(0, std::copysign(1e3, q) * size * dq / 20));
            REQUIRE(step.outcome == StepOutcome::accepted);
            s = step.state;
            const double w = 0.5 * (mean + s.stress).dot(step.strain_increment);
            work += w;
            exchanged += std::abs(w);
          }
        CHECK(s.q() == Approx(1e3 * q).epsilon(1e-9));
        CHECK(work > -1e-6 * exchanged);
      }
}

TEST_CASE("wobbles on the way up leave the undrained peak within 3 %") {
  for (const auto& material : {inl2(), octo()}) {
    const auto peak = [&](double wobble_kPa) {
      State s = material.isotropic(100e3, 1.11);
      double largest = 0, next = 5e3;
      const auto strained = [&](double strain) {
        s = advance_point(material, s, Control::strain_path(strain)).state;
        largest = std::max(largest, s.q());
      };
      for (int i = 0; i < 300; ++i) {
        strained(2e-5);
        if (wobble_kPa == 0 || s.q() < next) continue;
        next = s.q() + 5e3;
        for (double down = 1e3 * wobble_kPa; down > 250 * wobble_kPa; down /= 1.5) {
          const double top = s.q();  // a load that rings
          while (s.q() > top - down) strained(-2e-6);
          for (int up = 0; up < 500 && s.q() < top - 0.2 * down; ++up) strained(2e-6);
        }
      }
      return largest;
    };
    const double plain = peak(0);
    for (const double wobble : {0.3, 1.0, 4.0, 8.0}) {
      INFO("wobbles of " << wobble << " kPa");
      CHECK(peak(wobble) < 1.001 * plain);
      CHECK(peak(wobble) > 0.97 * plain);
    }
  }
}

namespace {

/// Oedometric: the axial stress to this, or the axial strain by this; radial strain held.
template <class Space>
PointStep<Space> oedometric(const Law<Space>& material, const PointState<Space>& s,
                            double axial_kPa, double strain = 0) {
  MixedControl<Space> c;
  c.strain = Matrix<Space>::Identity();
  c.increment(0) = strain;
  if (strain == 0) {
    c.stress(0, 0) = 1;
    c.strain(0, 0) = 0;
    c.increment(0) = 1e3 * axial_kPa - s.stress(0);
  }
  return advance_point(material, s, c, {.relative = 1e-8, .step_limit = 3000});
}

template <class Space>
void unloads_oedometrically(Interpolation kind, double h0, double void_ratio, double most_kPa) {
  const auto material = law<Space>(kind, h0);
  const auto loaded = oedometric<Space>(material, material.isotropic(100e3, void_ratio), most_kPa);
  REQUIRE(loaded.outcome == StepOutcome::accepted);
  const auto rest = [](const PointState<Space>& at) {  // K
    return (trace<Space>(at.stress) / at.stress(0) - 1) / 2;
  };
  REQUIRE(rest(loaded.state) < 0.7);
  PointState<Space> s = loaded.state;
  double k = 0, e = 0;
  for (double axial = 0.98; axial > 0.01; axial -= 0.02) {
    const auto step = oedometric<Space>(material, s, axial * most_kPa);
    INFO("axial stress " << axial * most_kPa << " kPa: " << step.message);
    REQUIRE(step.outcome == StepOutcome::accepted);
    CHECK(step.steps < 100);
    s = step.state;
    CHECK(rest(s) > k);
    CHECK(s.void_ratio > e);
    k = rest(s);
    e = s.void_ratio;
  }
  CHECK(k > 1.2);  // into extension
  const auto once = oedometric<Space>(material, loaded.state, s.stress(0) / 1e3);
  REQUIRE(once.outcome == StepOutcome::accepted);
  CHECK(once.state.stress.isApprox(s.stress, 1e-5));
  // The same by strain.
  const auto by_strain = oedometric<Space>(material, loaded.state, 0, once.strain_increment(0));
  REQUIRE(by_strain.outcome == StepOutcome::accepted);
  CHECK(by_strain.state.stress.isApprox(s.stress, 1e-4));
  // Loaded again it comes back to where it was left, and goes on.
  const auto again = oedometric<Space>(material, s, 1.2 * most_kPa);
  REQUIRE(again.outcome == StepOutcome::accepted);
  CHECK(rest(again.state) == Approx(rest(loaded.state)).margin(0.02));
}

}  // namespace

TEST_CASE(
    "oedometric unloading: K rises through 1 and the specimen swells, to the end and however cut") {
  for (const double void_ratio : {0.7, 0.85, 1.0})
    for (const double most_kPa : {400.0, 1000.0}) {
      INFO("e " << void_ratio << ", to " << most_kPa << " kPa");
      unloads_oedometrically<Axisymmetric>(Interpolation::inl2, kInl2, void_ratio, most_kPa);
      unloads_oedometrically<Axisymmetric>(Interpolation::octolinear, kOcto, void_ratio, most_kPa);
    }
  unloads_oedometrically<Tensor>(Interpolation::inl2, kInl2, 0.85, 1000);
  unloads_oedometrically<Tensor>(Interpolation::octolinear, kOcto, 0.85, 1000);
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

TEST_CASE("the moduli are continuous at q = 0, whatever came before") {
  for (const auto& material : {inl2(), octo()})
    for (const double before : {10.0, 40.0, 80.0, -40.0}) {
      const State start = along(material, material.isotropic(100e3, 1.0), {before});
      const auto above = moduli(material, along(material, start, {0.01}));
      const auto below = moduli(material, along(material, start, {-0.01}));
      CHECK(above.plus.isApprox(below.plus, 1e-5));
      CHECK(above.minus.isApprox(below.minus, 1e-5));
    }
}

TEST_CASE("the moduli are those of this law, stress and void ratio, whatever was asked before") {
  std::optional<Interpolated<Axisymmetric>> material;
  const auto column = [&material](double h0, double eta, double e) {
    material.emplace(law<Axisymmetric>(Interpolation::inl2, h0));  // where the last one was
    return Eigen::Vector2d(moduli(*material, state_at(*material, 70, eta, e)).plus.col(0));
  };
  const Eigen::Vector2d first = column(kInl2, 0.5, 1);
  CHECK(column(2 * kInl2, 0.5, 1)(0) < 0.9 * first(0));
  CHECK(column(2 * kInl2, 0.5, 1.1)(0) > 1.1 * column(2 * kInl2, 0.5, 1)(0));
  CHECK(column(kInl2, 0.4, 1)(0) < 0.9 * first(0));
  CHECK(column(kInl2, 0.5, 1) == first);
}
