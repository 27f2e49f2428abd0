// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/specimen.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "sim/materials/sanisand.hpp"
#include "tests/sim/materials/parameter_sets.hpp"
#include "tests/sim/specimen/specimens.hpp"

using namespace triax::sim;

namespace {

SpecimenProperties cylinder() {
  SpecimenProperties p;
  p.height_m = 0.14;
  p.diameter_m = 0.07;
  p.water_compressibility = 1 / 2.2e9;
  p.system_compliance = 5e-13;
  p.drainage_resistance = 1e11;
  return p;
}

Specimen loose(const SpecimenProperties& properties = cylinder(), double p_pa = 100e3) {
  return Specimen(std::make_shared<Sanisand<Axisymmetric>>(test::s28_general()), properties, 1.086,
                  p_pa, 300e3);
}

SpecimenBoundary free_piston(double cell_rate, bool open) {
  SpecimenBoundary b;
  b.cell_pressure_rate_pa_per_s = cell_rate;
  b.water.kind = open ? WaterDrive::Kind::drained : WaterDrive::Kind::closed;
  b.water.back_pressure_pa = 300e3;
  return b;
}

SpecimenBoundary compression(double velocity, bool open) {
  SpecimenBoundary b = free_piston(0, open);
  b.axis.kind = AxialDrive::Kind::rigid;
  b.axis.velocity_m_per_s = velocity;
  return b;
}

double bulk_modulus(const PointState<Axisymmetric>& state) {
  return Sanisand<Axisymmetric>(test::s28_general()).bulk_modulus(state);
}

}  // namespace

TEST_CASE("Skempton's B follows from skeleton and compliance") {
  const Specimen specimen = loose();
  const auto& start = specimen.start();
  const auto step = specimen.advance(start, free_piston(10, false), 1);
  REQUIRE(step.outcome == StepOutcome::accepted);
  const double b = (step.state.pore_pressure - start.pore_pressure) / 10;
  const double storage = specimen.water_compliance(start) / specimen.volume_m3(start);
  CHECK(b == Approx(1 / (1 + storage * bulk_modulus(start.material))).epsilon(1e-5));
  CHECK(b > 0.96);
  CHECK(b < 0.999);
  CHECK(step.state.drained_volume_m3 == 0);
}

TEST_CASE("rigid water and lines give B = 1 and no volume change") {
  SpecimenProperties p = cylinder();
  p.water_compressibility = p.system_compliance = 0;
  const Specimen specimen = loose(p);
  const auto step = specimen.advance(specimen.start(), free_piston(10e3, false), 1);
  CHECK(step.state.pore_pressure == Approx(310e3).epsilon(1e-12));
  CHECK(step.state.material.void_ratio == Approx(1.086).epsilon(1e-14));
}

TEST_CASE("undrained compression with rigid water is the bare material point") {
  SpecimenProperties p = cylinder();
  p.water_compressibility = p.system_compliance = 0;
  const Specimen specimen = loose(p);
  const SpecimenBoundary b = compression(1e-5, false);
  SpecimenState state = specimen.start();
  for (int i = 0; i < 140; ++i) state = specimen.advance(state, b, 1).state;
  CHECK(state.height_m == Approx(0.14 - 140e-5).epsilon(1e-13));
  const auto point =
      advance_point(specimen.law(), specimen.start().material,
                    MixedControl<Axisymmetric>::strain_path(std::log(0.14 / state.height_m)));
  CHECK(state.material.q() == Approx(point.state.q()).epsilon(1e-9));
  CHECK(state.material.p() == Approx(point.state.p()).epsilon(1e-9));
  CHECK(state.pore_pressure ==
        Approx(400e3 + state.material.q() / 3 - state.material.p()).epsilon(1e-9));
}

TEST_CASE("consolidation through a resistance lags and ends where the skeleton says") {
  const Specimen specimen = loose();
  SpecimenState state = specimen.start();
  const SpecimenBoundary ramp = free_piston(1e3, true);
  for (int i = 0; i < 100; ++i) {
    const auto step = specimen.advance(state, ramp, 1);
    REQUIRE(step.outcome == StepOutcome::accepted);
    state = step.state;
  }
  const double lag = state.pore_pressure - 300e3;
  // Quasi-steady lag: R V dp/(K dt).
  const double bulk = bulk_modulus(state.material);
  CHECK(lag == Approx(1e11 * specimen.volume_m3(state) * 1e3 / bulk).epsilon(0.05));

  for (int i = 0; i < 300; ++i) state = specimen.advance(state, free_piston(0, true), 1).state;
  CHECK(state.pore_pressure == Approx(300e3).margin(1));
  CHECK(state.material.p() == Approx(200e3).margin(1));
  const auto dry = advance_point(specimen.law(), specimen.start().material,
                                 MixedControl<Axisymmetric>::stress_path(100e3, 0));
  CHECK(state.material.void_ratio == Approx(dry.state.void_ratio).epsilon(1e-6));
  CHECK(std::log(0.14 / state.height_m) == Approx(dry.strain_increment(0)).epsilon(1e-5));
  const double water = specimen.volume_m3(specimen.start()) - specimen.volume_m3(state);
  CHECK(state.drained_volume_m3 == Approx(water).epsilon(1e-4));
}

TEST_CASE("the length of the step does not matter") {
  const Specimen specimen = loose();
  const SpecimenBoundary b = compression(1e-6, true);
  SpecimenState coarse = specimen.start(), fine = specimen.start();
  for (int i = 0; i < 20; ++i) coarse = specimen.advance(coarse, b, 10).state;
  for (int i = 0; i < 2000; ++i) fine = specimen.advance(fine, b, 0.1).state;
  CHECK(coarse.pore_pressure == Approx(fine.pore_pressure).margin(20));
  CHECK(coarse.material.q() == Approx(fine.material.q()).epsilon(1e-3));
}

TEST_CASE("area is that of the right cylinder in engineering strains") {
  const Specimen specimen = loose();
  const SpecimenBoundary b = compression(5e-6, true);
  SpecimenState state = specimen.start();
  const double area_0 = specimen.area_m2(state), volume_0 = specimen.volume_m3(state);
  for (int i = 0; i < 200; ++i) state = specimen.advance(state, b, 1).state;
  const double strain = 1 - state.height_m / 0.14;
  const double volumetric = 1 - specimen.volume_m3(state) / volume_0;
  CHECK(volumetric > 0);
  CHECK(specimen.area_m2(state) == Approx(area_0 * (1 - volumetric) / (1 - strain)).epsilon(1e-12));
  CHECK(specimen.axial_force(state) == Approx(state.material.q() * specimen.area_m2(state)));
}

TEST_CASE("a load that the undrained specimen cannot carry is a loss of control") {
  const Specimen specimen = loose();
  SpecimenBoundary b;
  b.axis.kind = AxialDrive::Kind::force;
  b.axis.stress_rate_pa_per_s = 1e3;
  const auto step = specimen.advance(specimen.start(), b, 100);
  CHECK(step.outcome == StepOutcome::lost_control);
  CHECK(step.done_s == Approx(37.3).margin(0.5));
  CHECK(step.state.material.q() == Approx(37.3e3).margin(500));
  CHECK(specimen.start().material.q() == 0);
}

TEST_CASE("what no specimen can be is refused") {
  SpecimenProperties p = cylinder();
  p.height_m = -1;
  CHECK_THROWS_AS(loose(p), std::invalid_argument);
  p = cylinder();
  p.drainage_resistance = -1;
  CHECK_THROWS_AS(loose(p), std::invalid_argument);
  CHECK_THROWS_AS(loose(cylinder(), 0), std::invalid_argument);
  CHECK(loose().advance(loose().start(), compression(1, false), 1).outcome == StepOutcome::failed);
}

// With every imperfection zero the specimen is the bare material point.
namespace {

void check_same(const SpecimenState& state, const PointStep<Axisymmetric>& point) {
  const double p = point.state.p();
  CHECK(std::abs(state.material.p() - p) < 2e-9 * p);
  CHECK(std::abs(state.material.q() - point.state.q()) < 2e-9 * p);
  CHECK(std::abs(state.material.void_ratio - point.state.void_ratio) < 1e-9);
  CHECK(std::abs(std::log(0.14 / state.height_m) - point.strain_increment(0)) < 1e-9);
}

/// The whole path in one increment, more closely than the specimen integrates.
PointStep<Axisymmetric> follow(const Specimen& specimen, const PointState<Axisymmetric>& from,
                               const MixedControl<Axisymmetric>& control) {
  PointTolerance close;
  close.relative = 1e-13;
  auto point = advance_point(specimen.law(), from, control, close);
  REQUIRE(point.done == 1);
  return point;
}

}  // namespace

TEST_CASE("without imperfections the specimen is the bare material point") {
  const test::LawPointer law = GENERATE(test::inl2_law_of_s28(), test::sanisand_of_s28());
  const Specimen specimen = test::loose(law, test::bare());
  const SpecimenState& start = specimen.start();

  SECTION("undrained compression") {
    const SpecimenState s = test::run(specimen, start, test::moved(1e-5), 0.25, 600);
    check_same(s, follow(specimen, start.material,
                         MixedControl<Axisymmetric>::strain_path(std::log(0.14 / s.height_m))));
    CHECK(specimen.volume_m3(s) == Approx(specimen.volume_m3(start)).epsilon(1e-14));
  }
  SECTION("drained compression") {
    const SpecimenState s =
        test::run(specimen, start, test::moved(5e-6, test::Water::drained), 0.25, 1200);
    check_same(
        s, follow(specimen, start.material,
                  MixedControl<Axisymmetric>::drained_compression(std::log(0.14 / s.height_m))));
  }
  SECTION("isotropic consolidation") {
    const SpecimenState s = test::run(specimen, start, free_piston(500, true), 0.25, 800);
    CHECK(s.material.q() == Approx(0).margin(1e-4));
    const auto point =
        follow(specimen, start.material, MixedControl<Axisymmetric>::stress_path(100e3, 0));
    check_same(s, point);
    CHECK(s.material.p() == Approx(200e3).epsilon(1e-9));
  }
  SECTION("consolidation at a constant ratio of stresses") {
    // dq/dp' = 0.5: dq = 0.5 dp', dσ_c = dp' − dq/3
    SpecimenBoundary b = free_piston(100 * (1 - 0.5 / 3), true);
    b.axis.kind = AxialDrive::Kind::force;
    b.axis.stress_rate_pa_per_s = 50;
    SpecimenState s = start;
    for (int i = 0; i < 1600; ++i) {
      b.axis.stress_pa = 50 * 0.25 * i;
      s = specimen.advance(s, b, 0.25).state;
    }
    check_same(
        s, follow(specimen, start.material, MixedControl<Axisymmetric>::stress_path(40e3, 20e3)));
  }
  SECTION("constant q with falling p'") {
    SpecimenBoundary b = free_piston(50.0 / -3, true);
    b.axis.kind = AxialDrive::Kind::force;
    b.axis.stress_pa = 40e3;
    // To q first in one step, drained at constant p'; then the cell pressure falls.
    const SpecimenState sheared = specimen.advance(start, b, 800).state;
    b.cell_pressure_rate_pa_per_s = -50;
    SpecimenState s = sheared;
    for (int i = 0; i < 2400; ++i) s = specimen.advance(s, b, 0.25).state;
    auto point =
        follow(specimen, sheared.material, MixedControl<Axisymmetric>::stress_path(-30e3, 0));
    point.strain_increment(0) += std::log(0.14 / sheared.height_m);
    check_same(s, point);
  }
  SECTION("proportional strain paths") {
    const double r = GENERATE(0.7, 1.3);
    // dε₁ + 2R dε₃ = 0: dε_v = (1 − 1/R) dε₁, and the flow that this asks for.
    SpecimenBoundary b = test::moved(5e-6, test::Water::flow);
    SpecimenState s = start;
    for (int i = 0; i < 600; ++i) {
      const double axial = -std::log1p(-5e-6 * 0.25 / s.height_m);
      b.water.flow_m3_per_s = -specimen.volume_m3(s) * std::expm1(-(1 - 1 / r) * axial) / 0.25;
      const auto step = specimen.advance(s, b, 0.25);
      if (!test::accepted(step)) break;
      s = step.state;
    }
    check_same(s, follow(specimen, start.material,
                         MixedControl<Axisymmetric>::strain_path(std::log(0.14 / s.height_m), r)));
  }
}

TEST_CASE("the same state and boundary give the same bits") {
  const Specimen specimen = test::loose(test::inl2_law_of_s28(), test::real());
  const SpecimenState one = test::run(specimen, specimen.start(), test::moved(1e-5), 0.25, 50);
  const SpecimenState two = test::run(specimen, specimen.start(), test::moved(1e-5), 0.25, 50);
  CHECK(one.material.stress == two.material.stress);
  CHECK(one.pore_pressure == two.pore_pressure);
  CHECK(one.height_m == two.height_m);
}
