// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/control/interpolated_solver.hpp"

#include <catch2/catch.hpp>

#include "sim/law/interpolated_compliance.hpp"
#include "sim/point/point_driver.hpp"
#include "tests/sim/materials/interpolated_laws.hpp"
#include "tests/sim/materials/random_tensors.hpp"

using namespace triax::sim;
using namespace triax::sim::test;
using Six = Vector<Tensor>;
using Square = Matrix<Tensor>;

namespace {

/// A coupling of two shear components far below round-off: the six components are then solved
/// together.
InterpolatedForm<Tensor> coupled(InterpolatedForm<Tensor> form) {
  form.plus(3, 4) = 1e-300;
  return form;
}

/// Elasticity, with columns of the principal axes that differ in loading and unloading.
InterpolatedForm<Tensor> any_form(RandomTensors& random, bool quadratic) {
  InterpolatedForm<Tensor> form;
  form.plus = isotropic_stiffness<Tensor>(1 / (9 * 40e6), 1 / (4 * 30e6));
  form.minus = form.plus;
  for (int j = 0; j < 3; ++j)
    for (Square* side : {&form.plus, &form.minus})
      side->col(j).head<3>() += random.uniform(0, 4e-9) * random.direction<Tensor>().head<3>();
  form.quadratic = quadratic;
  return form;
}

/// Three conditions on the principal components, and each shear held at zero in stress or strain.
MixedControl<Tensor> any_tensor_control(RandomTensors& random) {
  MixedControl<Tensor> c;
  const bool strains_only = random.uniform(0, 1) < 0.3;
  for (int i = 0; i < 3; ++i) {
    const double in_strain = strains_only ? 1 : random.uniform(0, 1);
    c.strain.row(i).head<3>() = 30e6 * in_strain * random.direction<Tensor>().head<3>();
    c.stress.row(i).head<3>() = (1 - in_strain) * random.direction<Tensor>().head<3>();
    c.increment(i) = random.uniform(-1e3, 1e3);
    (strains_only || random.uniform(0, 1) < 0.5 ? c.strain : c.stress)(3 + i, 3 + i) = 2;
  }
  return c;
}

PointRate<Tensor> solved(const InterpolatedForm<Tensor>& form, const MixedControl<Tensor>& control,
                         const Six& guess = Six::Zero()) {
  return solve_interpolated(form, PreparedControl<Tensor>(control, 30e6), guess);
}

void check_alike(const PointRate<Tensor>& a, const PointRate<Tensor>& b) {
  REQUIRE(a.controllable == b.controllable);
  CHECK(a.limiting_variable == b.limiting_variable);
  if (!a.controllable) return;
  // A residual of 1e-13 leaves as much more as the conditions are near their limit.
  const double near = 1e-12 / std::min(1.0, a.determinant);
  CHECK((a.stress - b.stress).norm() <= near * b.stress.norm());
  CHECK((a.strain - b.strain).norm() <= near * b.strain.norm());
  CHECK(a.determinant == Approx(b.determinant).epsilon(1e-10 / std::min(1.0, a.determinant)));
}

/// The law with that coupling, which keeps it from its principal components.
class Coupled : public Interpolated<Tensor> {
 public:
  using Interpolated<Tensor>::Interpolated;
  void response(const PointState<Tensor>& state, Response<Tensor>& out) const override {
    Interpolated<Tensor>::response(state, out);
    interpolated_form(out) = coupled(interpolated_form(out));
  }
};

template <class Law>
PointState<Tensor> driven(const Law& law, const MixedControl<Tensor>& control, int increments,
                          double tolerance) {
  PointState<Tensor> s = law.isotropic(100e3, 0.95);
  const PointTolerance settings{.relative = tolerance};
  PointDriver<Tensor> driver(law, s, control, settings);
  for (int i = 0; i < increments; ++i) {
    const auto step = driver.advance(s);
    REQUIRE(step.outcome == StepOutcome::accepted);
    s = step.state;
  }
  return s;
}

}  // namespace

TEST_CASE("principal components alone answer as all six do") {
  RandomTensors random;
  int met = 0, lost = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto form = any_form(random, i % 2 == 0);
    const auto control = any_tensor_control(random);
    REQUIRE(PreparedControl<Tensor>(control, 30e6).principal);
    const auto found = solved(form, control);
    check_alike(found, solved(coupled(form), control));
    (found.controllable ? met : lost)++;
    if (!found.controllable) continue;
    CHECK(found.stress.tail<3>().isZero(0));
    CHECK(found.strain.tail<3>().isZero(0));
    const InterpolatedCompliance<Tensor> law(form);
    CHECK((law.strain(found.stress) - found.strain).norm() < 1e-12 * found.strain.norm());
    const Six rest =
        control.stress * found.stress + control.strain * found.strain - control.increment;
    CHECK(rest.norm() < 1e-10 * control.increment.norm());
  }
  CHECK(met > 1000);
  CHECK(lost > 20);
}

TEST_CASE("where shear is asked for, or depends on other components, all six are solved") {
  RandomTensors random;
  for (int i = 0; i < 300; ++i) {
    const auto form = any_form(random, i % 2 == 0);
    auto control = MixedControl<Tensor>::strains(1e-4 * random.direction<Tensor>());
    const auto sheared = solved(form, control);
    if (!sheared.controllable) continue;
    CHECK(sheared.strain.isApprox(control.increment, 1e-12));
    CHECK(sheared.stress(3) * form.plus(3, 3) == Approx(control.increment(3)).epsilon(1e-9));
    // σ₁ + √2 σ₁₂ asked for, not σ₁ alone.
    control = MixedControl<Tensor>::stresses(1e3 * Six::Unit(0));
    control.stress(0, 3) = 1;
    control.stress(3, 0) = 0.5;
    const auto slanted = solved(form, control);
    REQUIRE(slanted.controllable);
    CHECK((control.stress * slanted.stress - control.increment).norm() < 1e-9);
    CHECK(std::abs(slanted.stress(3)) > 100);
    // A shear stress in the strain along axis 1, with ε₁ held and σ₁₂ at zero.
    auto leaning = form;
    leaning.plus(0, 3) = leaning.minus(0, 3) = leaning.plus(3, 0) = leaning.minus(3, 0) = 3e-9;
    control = MixedControl<Tensor>::strains(1e-4 * Six::Unit(0));
    const auto held = solved(leaning, control);
    if (!held.controllable) continue;
    CHECK(held.strain.isApprox(control.increment, 1e-9));
    CHECK(held.stress(3) != 0);
  }
}

TEST_CASE("principal components: equal stresses answer as in axisymmetry, axes may be exchanged") {
  const auto tensor = law<Tensor>(Interpolation::inl2, kInl2);
  for (const double eta : {0.0, 0.4, -0.4})
    for (const double angle : {0.3, 1.4, 2.6, 4.0, 5.5}) {
      const auto two = state_at(inl2(), 100, eta, 1.0);
      MixedControl<Axisymmetric> c =
          MixedControl<Axisymmetric>::drained_compression(std::cos(angle));
      c.increment(1) = 20e6 * std::sin(angle);
      const auto response = inl2().response(two);
      const auto plane = solve_control<Axisymmetric>(
          response, PreparedControl<Axisymmetric>(c, 30e6), {}, Vector<Axisymmetric>::Zero());
      const auto s = tensor.start(as_tensor(two.stress), 1.0);
      const auto control = as_tensor(c);
      const auto rate = point_rate<Tensor>(tensor, s, control);
      REQUIRE(rate.controllable == plane.controllable);
      if (!plane.controllable) continue;
      CHECK(rate.strain.isApprox(as_tensor(plane.strain), 1e-11));
      CHECK(rate.stress.isApprox(as_tensor(plane.stress), 1e-11));
      Eigen::Matrix3d exchange;  // 1 to 2, 2 to 3, 3 to 1
      exchange << 0, 0, 1, 1, 0, 0, 0, 1, 0;
      const Square turned = rotation(exchange);
      const auto there = tensor.start(Six(turned * s.stress), 1.0);
      const auto rate_there = point_rate<Tensor>(tensor, there, turned_control(control, turned));
      REQUIRE(rate_there.controllable);
      // Without a stress ratio the base takes axis 1 for its own, at next to no plastic strain.
      CHECK(rate_there.strain.isApprox(turned * rate.strain, eta == 0 ? 0.01 : 1e-11));
    }
}

TEST_CASE("principal components: a linear form is objective under any rotation") {
  RandomTensors random;
  InterpolatedForm<Tensor> form = any_form(random, true);
  for (int i = 0; i < 50; ++i) {
    form.minus = form.plus;
    const auto control = any_tensor_control(random);
    const auto rate = solved(form, control);
    const Square turned = rotation(random.turn());
    InterpolatedForm<Tensor> there{turned * form.plus * turned.transpose(), {}, true};
    there.minus = there.plus;
    const auto rate_there = solved(there, turned_control(control, turned));
    REQUIRE(rate.controllable == rate_there.controllable);
    if (rate.controllable && rate.determinant > 1e-3)
      CHECK(rate_there.strain.isApprox(turned * rate.strain, 1e-9));
  }
}

TEST_CASE("principal components: paths of INL2 and octolinear end where six components end") {
  for (const auto kind : {Interpolation::inl2, Interpolation::octolinear}) {
    const double h0 = kind == Interpolation::inl2 ? kInl2 : kOcto;
    const auto base = std::make_shared<SanisandModuli<Tensor>>(with_h0(h0));
    const Interpolated<Tensor> plain(kind, base);
    const Coupled whole(kind, base);
    const int n = 50;
    auto true_triaxial =
        MixedControl<Tensor>::strains((Six() << 0.02, 0.004, -0.014, 0, 0, 0).finished() / n);
    for (const auto& control : {MixedControl<Tensor>::strain_path(0.04 / n),
                                MixedControl<Tensor>::drained_compression(0.02 / n), true_triaxial})
      for (const double tolerance : {1e-4, 1e-9}) {
        // Where the integrator stops short of a face between zones, round-off chooses its steps.
        if (kind == Interpolation::octolinear && tolerance < 1e-4) continue;
        const auto a = driven(plain, control, n, tolerance);
        const auto b = driven(whole, control, n, tolerance);
        CHECK((a.stress - b.stress).norm() < 1e-12 * b.stress.norm());
        CHECK(a.void_ratio == Approx(b.void_ratio).epsilon(1e-12));
      }
  }
}
