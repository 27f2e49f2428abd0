// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/paths/grain_law.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/grains/state/grain_measures.hpp"
#include "tests/sim/grains/law_of_grains.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

using Pair = Vector<Axisymmetric>;

std::string refusal_of(const GrainState& state) {
  try {
    const GrainLaw law(state);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

/// Driven by the same control until it is lost, at most `most` times.
PointStep<Axisymmetric> until_lost(const GrainLaw& law, const GrainControl& control, int most) {
  PointStep<Axisymmetric> step;
  step.state = start_of(law);
  step.outcome = StepOutcome::accepted;
  for (int i = 0; i < most && step.outcome == StepOutcome::accepted; ++i)
    step = advance_point<Axisymmetric>(law, step.state, control);
  return step;
}

}  // namespace

TEST_CASE("Grains stand as they were, at rest under an isotropic stress") {
  const GrainLaw& law = *dense_grains();
  const GrainPoint s = start_of(law);
  REQUIRE_FALSE(law.objection(s));
  CHECK(law.grains() == 500);
  CHECK(law.pressure_pa() == Approx(1e5).epsilon(0.01));
  CHECK(std::abs(s.q()) < 3e-5 * s.p());
  CHECK(law.void_ratio() == Approx(measure(dense_specimen().state).void_ratio).epsilon(1e-3));
  CHECK(measure(grains_of(s)).unbalanced < 1e-3);
  const auto stiffness = std::get<StiffnessForm<Axisymmetric>>(law.response(s)).stiffness;
  CHECK(stiffness.determinant() > 0);
  CHECK(stiffness(0, 0) > 20e6);
  // Isotropic elasticity has C₁₁ = C₂₂ − C₁₂/√2 in these components.
  CHECK(stiffness(0, 0) == Approx(stiffness(1, 1) - stiffness(0, 1) / std::sqrt(2)).epsilon(0.15));
}

TEST_CASE("Given strains are those that the engine makes of the same grains") {
  const GrainLaw& law = *dense_grains();
  const GrainPoint from = start_of(law);
  const Pair strain{8e-5, -3e-5};
  const auto step = advance_point<Axisymmetric>(law, from, GrainControl::strains(strain));
  REQUIRE(step.outcome == StepOutcome::accepted);
  Grains engine(grains_of(from));
  StrainPace pace;
  pace.least_pressure_pa = 0.05 * law.pressure_pa();
  pace.small_stress_pa = law.tolerance(from).stress_pa;
  strain_box(engine, strain, strain_steps(engine.state(), strain.norm(), pace));
  CHECK(grains_of(step.state).grains == engine.state().grains);
  CHECK((step.state.stress - components(axisymmetric_stress(engine.state()))).norm() == 0);
  CHECK((step.strain_increment - strain).norm() < 1e-12);
  CHECK((step.stress_increment - (step.state.stress - from.stress)).norm() == 0);
  const double e = measure(grains_of(step.state)).void_ratio;
  CHECK(step.state.void_ratio == Approx(e).epsilon(1e-9));
}

TEST_CASE("An isotropic stress is reached to the tolerance, and the grains get denser") {
  const GrainLaw& law = *loose_grains();
  GrainPoint s = start_of(law);
  const auto control = GrainControl::stress_path(1000, 0);
  for (int i = 1; i <= 5; ++i) {
    const auto step = advance_point<Axisymmetric>(law, s, control);
    REQUIRE(step.outcome == StepOutcome::accepted);
    CHECK(step.error <= 1e-3);
    CHECK(step.state.p() == Approx(s.p() + 1000).margin(3 * step.error * s.p() + 3));
    s = step.state;
  }
  CHECK(std::abs(s.q()) < 5e-4 * s.p());
  CHECK(s.void_ratio < law.void_ratio());
}

TEST_CASE("An undrained increment under load holds volume and q") {
  const GrainLaw& law = *dense_grains();
  const GrainPoint from = start_of(law);
  const auto step = advance_point<Axisymmetric>(law, from, undrained_load(500));
  REQUIRE(step.outcome == StepOutcome::accepted);
  CHECK(std::abs(trace<Axisymmetric>(step.strain_increment)) < 1e-12);
  CHECK(step.state.void_ratio == Approx(from.void_ratio).epsilon(1e-11));
  CHECK(step.state.q() - from.q() == Approx(500).margin(3 * step.error * from.p() + 1e-6));
  CHECK(step.strain_increment(0) > 0);
}

TEST_CASE("The state given is not touched, and the same call gives the same bits") {
  const GrainLaw& law = *loose_grains();
  const GrainPoint from = start_of(law);
  const GrainPoint copy = from;
  const GrainState grains = grains_of(from);
  const auto control = GrainControl::drained_compression(5e-5);
  const auto a = advance_point<Axisymmetric>(law, from, control);
  const auto b = advance_point<Axisymmetric>(law, copy, control);
  CHECK(grains_of(from) == grains);
  CHECK(from.interior == copy.interior);
  CHECK(a.state.interior != b.state.interior);
  CHECK(grains_of(a.state) == grains_of(b.state));
  CHECK(a.state.stress == b.state.stress);
  const auto on_a = advance_point<Axisymmetric>(law, a.state, control);
  const auto on_b = advance_point<Axisymmetric>(law, b.state, control);
  CHECK(on_a.state.stress == on_b.state.stress);
}

TEST_CASE("Where nothing is asked nothing moves, and a strain is never left out") {
  const GrainLaw& law = *dense_grains();
  const GrainPoint from = start_of(law);
  const auto rests = advance_point<Axisymmetric>(law, from, GrainControl::drained_compression(0));
  REQUIRE(rests.outcome == StepOutcome::accepted);
  CHECK(rests.state.interior == from.interior);
  const auto little = advance_point<Axisymmetric>(law, from, GrainControl::stress_path(0.1, 0));
  CHECK(little.state.interior == from.interior);
  const auto crept =
      advance_point<Axisymmetric>(law, from, GrainControl::drained_compression(1e-11));
  REQUIRE(crept.outcome == StepOutcome::accepted);
  CHECK(crept.strain_increment(0) == Approx(1e-11).epsilon(1e-4));
  CHECK(grains_of(crept.state).steps - grains_of(from).steps < 100);
}

TEST_CASE("The rate foretells what a small increment does") {
  const GrainLaw& law = *dense_grains();
  GrainPoint s = start_of(law);
  const auto control = GrainControl::drained_compression(2e-5);
  for (int i = 0; i < 5; ++i) s = advance_point<Axisymmetric>(law, s, control).state;
  const auto rate = point_rate<Axisymmetric>(law, s, control);
  const auto step = advance_point<Axisymmetric>(law, s, control);
  REQUIRE(rate.controllable);
  CHECK((rate.stress - step.stress_increment).norm() < 0.2 * step.stress_increment.norm());
  CHECK((rate.strain - step.strain_increment).norm() < 0.2 * step.strain_increment.norm());
  const auto back = point_rate<Axisymmetric>(law, s, GrainControl::drained_compression(-2e-5));
  CHECK(back.stress(0) / back.strain(0) > rate.stress(0) / rate.strain(0));
}

TEST_CASE("Loose grains under an undrained load lose control near the peak that strains show") {
  const GrainLaw& law = *very_loose_grains();
  double peak = 0;
  GrainPoint s = start_of(law);
  for (int i = 0; i < 60; ++i) {
    s = advance_point<Axisymmetric>(law, s, GrainControl::strain_path(1e-4)).state;
    peak = std::max(peak, s.q());
  }
  REQUIRE(s.q() < 0.9 * peak);
  const auto lost = until_lost(law, undrained_load(500), 200);
  REQUIRE(lost.outcome == StepOutcome::lost_control);
  CHECK(lost.limiting_variable == 0);
  CHECK(lost.done < 1);
  CHECK(lost.state.q() > 0.4 * peak);
  CHECK(lost.state.q() < 1.2 * peak);
  CHECK_FALSE(lost.message.empty());
}

TEST_CASE("Without any stress the grains are a suspension that can still be strained") {
  const GrainLaw& law = *loose_grains();
  GrainPoint s = start_of(law);
  const Pair apart = -3e-3 * identity<Axisymmetric>();
  s = advance_point<Axisymmetric>(law, s, GrainControl::strains(apart)).state;
  const double loosened = s.p();
  CHECK(loosened < 0.02 * law.pressure_pa());
  CHECK_FALSE(law.objection(s));
  const auto step = advance_point<Axisymmetric>(law, s, GrainControl::strains(-2 * apart));
  CHECK(step.outcome == StepOutcome::accepted);
  CHECK(step.state.p() > loosened + 0.1 * law.pressure_pa());
}

TEST_CASE("What cannot be a specimen is refused in one line") {
  CHECK(refusal_of(calm_state()).find("not isotropic") != std::string::npos);
  GrainState moving = dense_specimen().state;
  Grains shaken(moving);
  shaken.drive(triaxial_drives(strain_rate_drive(20), strain_rate_drive(20)));
  shaken.step(400);
  CHECK(refusal_of(shaken.state()).find("not in equilibrium") != std::string::npos);
  const Cloud cloud = small_cloud(50);
  CHECK(refusal_of(make_grain_state(cloud.spheres, cloud.box, ContactLaw{})).find("no stress") !=
        std::string::npos);
  GrainState escaped = dense_specimen().state;
  escaped.grains.front().position[0] = escaped.box.high_m[0] + 1e-4;
  CHECK(refusal_of(escaped).find("outside") != std::string::npos);
  GrainDriving wrong;
  wrong.inertial_number = 0;
  CHECK_THROWS_AS(GrainLaw(dense_specimen().state, wrong), std::invalid_argument);
}

TEST_CASE("Grains cannot be put to another stress or void ratio") {
  const GrainLaw& law = *dense_grains();
  CHECK(law.objection(law.isotropic(2e5, law.void_ratio())));
  CHECK(law.objection(law.isotropic(law.pressure_pa(), 0.5)));
  const auto step = advance_point<Axisymmetric>(law, law.isotropic(2e5, 0.5),
                                                GrainControl::drained_compression(1e-5));
  CHECK(step.outcome == StepOutcome::failed);
}
