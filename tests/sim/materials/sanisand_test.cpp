// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/sanisand.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "sim/point/point_driver.hpp"
#include "tests/sim/materials/parameter_sets.hpp"

using namespace triax::sim;
using TriaxialSanisand = Sanisand<Axisymmetric>;
using Control = MixedControl<Axisymmetric>;

namespace {

struct PublishedRow {
  double strain_pct, q_kPa, p_kPa;
};

/// Undrained compression at `rows`, each compared within `margin` kPa.
void check_undrained(const TriaxialSanisand& law, double p0_pa, double e,
                     const std::vector<PublishedRow>& rows, double margin_kPa) {
  PointState<Axisymmetric> state = law.isotropic(p0_pa, e);
  double strain = 0;
  for (const PublishedRow& row : rows) {
    const double target = row.strain_pct / 100;
    const auto step = advance_point(law, state, Control::strain_path(target - strain));
    REQUIRE(step.outcome == StepOutcome::accepted);
    state = step.state;
    strain = target;
    INFO("axial strain " << row.strain_pct << " %");
    CHECK(state.q() / 1e3 == Approx(row.q_kPa).margin(margin_kPa));
    CHECK(state.p() / 1e3 == Approx(row.p_kPa).margin(margin_kPa));
    CHECK(state.void_ratio == Approx(e).epsilon(1e-12));
  }
}

/// p H and η K D at a state on the compression side.
struct CollapseTerms {
  double p_h, eta_k_d;
};
CollapseTerms collapse_terms(const TriaxialSanisand& law, const PointState<Axisymmetric>& state) {
  const auto l = law.loading(state);
  const double root = std::sqrt(2.0 / 3);
  const double h = l.stiffness / (law.alpha(state) - law.alpha_in(state)).dot(l.n) / root *
                   (l.bounding - law.alpha(state).dot(l.n));
  return {state.p() * h * root,
          state.q() / state.p() * law.bulk_modulus(state) * l.dilatancy / root};
}

}  // namespace

TEST_CASE("undrained Toyoura sand gives the published check numbers of the triaxial form") {
  // The multiaxial code gives 1063.788, 1333.938, 1403.187, 1348.419, 1266.847 for q.
  check_undrained(TriaxialSanisand(test::toyoura()), 3000e3, 0.833,
                  {{0.5, 1063.799, 2620.027},
                   {1, 1333.943, 2209.649},
                   {2, 1403.187, 1661.472},
                   {3, 1348.417, 1363.346},
                   {5, 1266.846, 1109.609}},
                  0.02);
}

TEST_CASE("undrained S28 variant gives the check numbers of the triaxial form") {
  check_undrained(TriaxialSanisand(test::s28_variant()), 100e3, 1.086,
                  {{0.05, 11.46094, 98.45798},
                   {0.15, 23.56143, 91.88525},
                   {0.25, 30.07361, 84.44783},
                   {0.55, 36.07664, 63.72534}},
                  0.002);
}

TEST_CASE("undrained S28-general gives its table") {
  check_undrained(TriaxialSanisand(test::s28_general()), 100e3, 1.086,
                  {{0.05, 11.8569, 98.4856},
                   {0.1, 19.4316, 95.3490},
                   {0.2, 28.8140, 87.6786},
                   {0.4, 36.3776, 71.8245},
                   {0.6, 36.8945, 57.7782},
                   {1.0, 30.4933, 36.6704},
                   {2.0, 12.6871, 11.5750}},
                  0.002);
}

TEST_CASE("S28-general peaks undrained at 37.21 kPa, 0.517 %, eta 0.5878, where pH = eta K D") {
  const TriaxialSanisand law(test::s28_general());
  PointState<Axisymmetric> state = law.isotropic(100e3, 1.086), before = state;
  double strain = 0;
  const double increment = 1e-5;
  for (; strain < 0.01; strain += increment) {
    before = state;
    state = advance_point(law, state, Control::strain_path(increment)).state;
    if (state.q() < before.q()) break;
  }
  // The peak lies in the last increment: isolate where dq/dε vanishes on copies.
  double low = 0, high = increment;
  PointState<Axisymmetric> peak = before;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    peak = advance_point(law, before, Control::strain_path(middle)).state;
    const bool rising =
        deviator_stress<Axisymmetric>(point_rate(law, peak, Control::strain_path(1)).stress) > 0;
    (rising ? low : high) = middle;
  }
  CHECK(peak.q() / 1e3 == Approx(37.21).margin(0.006));
  CHECK((strain + low) * 100 == Approx(0.517).margin(0.0006));
  CHECK(peak.q() / peak.p() == Approx(0.5878).margin(6e-5));
  const auto terms = collapse_terms(law, peak);
  CHECK(terms.p_h == Approx(terms.eta_k_d).epsilon(1e-7));
}

TEST_CASE("at constant q the volume turns to contraction where pH = eta K D") {
  const TriaxialSanisand law(test::s28_general());
  PointState<Axisymmetric> state = law.isotropic(100e3, 1.086);
  state = advance_point(law, state, Control::stress_path(10e3, 30e3)).state;
  const MixedControl falling = Control::stress_path(-1, 0);
  while (trace<Axisymmetric>(point_rate(law, state, falling).strain) < 0)
    state = advance_point(law, state, Control::stress_path(-1, 0)).state;
  const auto terms = collapse_terms(law, state);
  CHECK(terms.p_h == Approx(terms.eta_k_d).epsilon(1e-3));
  CHECK(state.q() / state.p() == Approx(0.589).margin(0.002));
  CHECK(point_rate(law, state, falling).second_order_work() < 0);
}

TEST_CASE("extension mirrors compression where the law is symmetric") {
  SanisandParameters p = test::s28_general();
  p.extension_ratio = 1;
  const TriaxialSanisand law(p);
  const auto start = law.isotropic(200e3, 1.0);
  const auto up = advance_point(law, start, Control::stress_path(0, 60e3));
  const auto down = advance_point(law, start, Control::stress_path(0, -60e3));
  CHECK(down.state.void_ratio == Approx(up.state.void_ratio).epsilon(1e-10));
  CHECK(deviator_stress<Axisymmetric>(down.strain_increment) ==
        Approx(-deviator_stress<Axisymmetric>(up.strain_increment)).epsilon(1e-9));
  CHECK(trace<Axisymmetric>(up.strain_increment) > 0);
}

TEST_CASE("strength at constant p' ends at the bounding line of its side") {
  const TriaxialSanisand law(test::s28_general());
  for (const double side : {1.0, -1.0}) {
    const auto step =
        advance_point(law, law.isotropic(300e3, 0.9), Control::stress_path(0, side * 600e3));
    REQUIRE(step.outcome == StepOutcome::lost_control);
    const double critical = side > 0 ? 1.2872 : 0.70 * 1.2872;
    CHECK(side * step.state.q() / step.state.p() ==
          Approx(critical * std::exp(-0.5 * law.state_parameter(step.state))).epsilon(1e-5));
  }
}

TEST_CASE("a reversal starts elastic and remembers where it began") {
  const TriaxialSanisand law(test::s28_general());
  const auto loaded =
      advance_point(law, law.isotropic(200e3, 1.0), Control::stress_path(0, 80e3)).state;
  const auto back = advance_point(law, loaded, Control::stress_path(0, -1e3));
  CHECK(law.alpha(back.state).isApprox(law.alpha(loaded), 1e-12));
  CHECK(deviator_stress<Axisymmetric>(back.strain_increment) * 2 / 3 ==
        Approx(-1e3 / (3 * law.shear_modulus(loaded))).epsilon(1e-3));
  const auto reversed = advance_point(law, loaded, Control::stress_path(0, -40e3)).state;
  CHECK(deviator_stress<Axisymmetric>(law.alpha_in(reversed)) ==
        Approx(80.0 / 200 - 0.01).epsilon(1e-9));
}

TEST_CASE("dilation builds fabric, contraction alone does not") {
  const TriaxialSanisand law(test::s28_general());
  auto dense = law.isotropic(100e3, 0.75);
  auto loose = law.isotropic(100e3, 1.1);
  for (int i = 0; i < 50; ++i) {
    dense = advance_point(law, dense, Control::strain_path(1e-3)).state;
    loose = advance_point(law, loose, Control::strain_path(1e-3)).state;
  }
  CHECK(law.fabric(dense)(0) < -0.1);
  CHECK(law.fabric(loose).isZero(0));
  CHECK(dense.q() / dense.p() > 1.25);
}

TEST_CASE("a void ratio at which the hardening vanishes is refused in words") {
  const TriaxialSanisand law(test::toyoura());
  const auto objection = law.objection(law.isotropic(100e3, 1.05));
  REQUIRE(objection);
  CHECK(objection->find("1/c_h = 1.03306") != std::string::npos);
  CHECK_FALSE(law.objection(law.isotropic(100e3, 1.0)));
  const auto step = advance_point(law, law.isotropic(100e3, 1.05), Control::strain_path(1e-3));
  CHECK(step.outcome == StepOutcome::failed);
  CHECK(step.state.p() == Approx(100e3));
}

TEST_CASE("tension is refused in words, at the start and on a path") {
  const TriaxialSanisand law(test::s28_general());
  const auto start = law.start(components(AxisymmetricStress{200e3, -10e3}), 0.9);
  const auto objection = law.objection(start);
  REQUIRE(objection);
  CHECK(objection->find("tensile") != std::string::npos);
}

TEST_CASE("absurd parameters are refused with their name") {
  SanisandParameters p = test::s28_general();
  p.poisson_ratio = 0.5;
  CHECK_THROWS_WITH(TriaxialSanisand(p), Catch::Contains("poisson_ratio is 0.5"));
  p = test::s28_general();
  p.critical_slope = std::nan("");
  CHECK_THROWS_AS(TriaxialSanisand(p), std::invalid_argument);
}
