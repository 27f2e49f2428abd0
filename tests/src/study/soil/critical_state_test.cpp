// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/critical_state.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::study;

namespace {

/// Drained: every quantity approaches its end like exp(−ε_q/length), so that η and e are straight
/// over the rate and the end is known: η 1.25, e 0.9, p′ 200 kPa.
ShearCurve approaching(double length, double last_strain) {
  ShearCurve curve;
  for (int i = 1; i <= 150; ++i) {
    const double strain = last_strain * (i / 150.0) * (i / 150.0),
                 left = std::exp(-strain / length);
    CurvePoint p;
    p.axial_strain = strain;
    p.shear_strain = strain;
    p.volumetric_strain = -0.05 * (1 - left);
    p.p_eff_kPa = 200 * std::exp(0.1 * left);
    p.q_kPa = (1.25 + 0.2 * left) * p.p_eff_kPa;
    p.void_ratio = 0.9 - 0.1 * left;
    curve.points.push_back(p);
  }
  return curve;
}

}  // namespace

TEST_CASE("A test that came to rest has its critical state reached") {
  const auto state = critical_state(approaching(0.02, 0.25), true);
  CHECK(state.kind == CriticalKind::reached);
  CHECK(state.eta.value == Approx(1.25).epsilon(1e-3));
  CHECK(state.void_ratio->value == Approx(0.9).margin(1e-3));
}

TEST_CASE("One that ended before is extrapolated, and says how far") {
  const auto state = critical_state(approaching(0.12, 0.25), true);
  CHECK(state.kind == CriticalKind::extrapolated);
  CHECK(state.eta.holds(1.25));
  CHECK(state.eta.value == Approx(1.25).epsilon(3e-3));
  CHECK(state.void_ratio->holds(0.9));
  CHECK(std::exp(state.log_p.value) == Approx(200).epsilon(0.01));
  CHECK(state.reason.starts_with("extrapolated by"));
}

TEST_CASE("One that was hardly sheared, or does not slow down, has none") {
  CHECK(critical_state(approaching(0.02, 0.04), true).kind == CriticalKind::none);
  const auto steady = critical_state(approaching(5, 0.25), true);
  CHECK(steady.kind == CriticalKind::none);
  CHECK_FALSE(steady.reason.empty());
}

TEST_CASE("The error of stresses counts where they are small") {
  auto curve = approaching(0.02, 0.25);
  for (auto& p : curve.points) p.q_kPa /= 50, p.p_eff_kPa /= 50;
  const auto state = critical_state(curve, true, 1);
  CHECK(state.log_p.error == Approx(0.25).epsilon(0.01));
  CHECK(state.eta.error == Approx(0.25 * std::hypot(1, 1.25)).epsilon(0.01));
}
