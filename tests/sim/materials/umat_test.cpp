// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/umat.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "sim/point/point_driver.hpp"
#include "tests/sim/materials/umat_fixture.hpp"

using namespace triax::sim;
using namespace triax::sim::test;
using Catch::Contains;
using Control = MixedControl<Axisymmetric>;
using TensorControl = MixedControl<Tensor>;

namespace {

template <class Space>
PointStep<Space> compress(const Material& material, double p0_kpa, double axial_strain,
                          const PointTolerance& tolerance = {}) {
  const auto& law = *material.law<Space>();
  return advance_point(law, law.isotropic(p0_kpa * 1e3, 0.8),
                       MixedControl<Space>::drained_compression(axial_strain), tolerance);
}

}  // namespace

TEST_CASE("a UMAT follows drained compression as its closed form does, in either space and unit") {
  if (!umat_fixture_is_there()) return;
  const ConeInCompression expected(100, 0.02);
  for (const double kpa : {1.0, 1000.0}) {
    ParameterSet set = umat_fixture(Misbehaviour::none, kpa);
    set.texts["stress_unit"] = kpa == 1 ? "kPa" : "MPa";
    const Material material = make_umat(set);
    const auto triaxial = compress<Axisymmetric>(material, 100, 0.02);
    INFO(triaxial.message);
    REQUIRE(triaxial.outcome == StepOutcome::accepted);
    CHECK(triaxial.state.q() / 1e3 == Approx(expected.q).epsilon(1e-6));
    CHECK(triaxial.state.stress(1) / std::sqrt(2.0) == Approx(100e3).epsilon(1e-9));
    const double volume = trace<Axisymmetric>(triaxial.strain_increment);
    CHECK(volume == Approx(expected.volumetric_strain).epsilon(1e-5));
    CHECK(triaxial.state.void_ratio == Approx(1.8 * std::exp(-volume) - 1).epsilon(1e-9));

    const auto full = compress<Tensor>(material, 100, 0.02);
    REQUIRE(full.outcome == StepOutcome::accepted);
    CHECK(full.state.q() / 1e3 == Approx(expected.q).epsilon(1e-6));
    CHECK(trace<Tensor>(full.strain_increment) == Approx(expected.volumetric_strain).epsilon(1e-5));
  }
}

TEST_CASE("signs, factors of shear and order of components are right for every component") {
  if (!umat_fixture_is_there()) return;
  const Material material = make_umat(umat_fixture());
  const Law<Tensor>& law = *material.tensor;
  const auto start = law.isotropic(100e3, 0.8);
  const Matrix<Tensor> elastic = isotropic_stiffness<Tensor>(kBulk * 1e3, kShear * 1e3);
  for (int i = 0; i < 6; ++i) {
    Vector<Tensor> strain = Vector<Tensor>::Zero();
    strain(i) = 1e-5;
    const auto step = law.integrate(start, strain);
    REQUIRE(step.failure.empty());
    CHECK((step.state.stress - start.stress - elastic * strain).norm() < 1e-6);
    CHECK((step.tangent - elastic).norm() < 1e-3);
  }
}

TEST_CASE("the tangent of plastic loading is the derivative of the stress") {
  if (!umat_fixture_is_there()) return;
  const Material material = make_umat(umat_fixture());
  const Law<Tensor>& law = *material.tensor;
  const auto start = law.isotropic(100e3, 0.8);
  Vector<Tensor> strain;
  strain << 0.01, -0.002, -0.004, 0.003, -0.001, 0.002;
  const auto step = law.integrate(start, strain);
  REQUIRE(step.state.memory(1) == 1);
  for (int i = 0; i < 6; ++i) {
    Vector<Tensor> high = strain, low = strain;
    high(i) += 1e-7;
    low(i) -= 1e-7;
    const Vector<Tensor> slope =
        (law.integrate(start, high).state.stress - law.integrate(start, low).state.stress) / 2e-7;
    CHECK((slope - step.tangent.col(i)).norm() < 1e-6 * step.tangent.norm());
  }
}

TEST_CASE("state variables start as the set says and are kept by the state, with time and count") {
  if (!umat_fixture_is_there()) return;
  ParameterSet set = umat_fixture();
  set.lists["initial_state"] = {0, 7};
  set.numbers["strain_rate_per_s"] = 1e-4;
  const Material material = make_umat(set);
  const auto& law = *material.axisymmetric;
  const auto start = law.isotropic(100e3, 0.8);
  CHECK(start.memory(0) == 0.8);
  CHECK(start.memory(1) == 7);
  const auto once = law.integrate(start, {1e-4, 0}).state;
  const auto twice = law.integrate(once, {1e-4, 0}).state;
  CHECK(once.memory(10) == 1);
  CHECK(twice.memory(10) == 2);
  CHECK(once.memory(9) == 0);
  CHECK(twice.memory(9) == Approx(1));  // s
  CHECK(law.memory_names().size() == static_cast<std::size_t>(start.memory.size()));
  CHECK(law.integrate(start, {1e-4, 0}).state.memory == once.memory);
}

TEST_CASE("SINV, SPRINC, SPRIND and ROTSIG of the host answer a plug-in") {
  if (!umat_fixture_is_there()) return;
  const Material material = make_umat(umat_fixture());
  const Law<Tensor>& law = *material.tensor;
  Vector<Tensor> stress;
  stress << 110e3, 100e3, 90e3, 5e3 * std::sqrt(2.0), 0, 0;
  const auto after = law.integrate(law.start(stress, 0.8), Vector<Tensor>::Zero()).state;
  CHECK(after.memory(2) == Approx(-100));
  CHECK(after.memory(3) == Approx(std::sqrt(0.5 * (100 + 100 + 400) + 3 * 25)));
  const double radius = std::sqrt(25.0 + 25);
  CHECK(after.memory(4) == Approx(-105 - radius));
  CHECK(after.memory(5) == Approx(-105 + radius));
  CHECK(after.memory(6) == Approx(-90));
  const double turned = M_PI / 3;  // twice the angle
  CHECK(after.memory(7) == Approx(-105 - 5 * std::cos(turned) - 5 * std::sin(turned)));
  CHECK(after.memory(8) == Approx(5 * std::sin(turned) - 5 * std::cos(turned)));
  CHECK(after.memory(11) == Approx(std::cos(M_PI / 8)));
}

TEST_CASE("whatever a plug-in does becomes words, and the next call is answered again") {
  if (!umat_fixture_is_there()) return;
  const auto message = [](Misbehaviour kind) {
    ParameterSet set = umat_fixture(kind);
    set.numbers["time_limit_s"] = 0.3;
    const Material material = make_umat(set);
    const auto step = compress<Axisymmetric>(material, 100, 0.001);
    CHECK(step.outcome == StepOutcome::failed);
    CHECK(step.done == 0);
    CHECK(step.state.p() == Approx(100e3));
    // Without strain the fixture behaves: the process was made anew.
    CHECK(material.axisymmetric->integrate(step.state, {0, 0}).failure.empty());
    return step.message;
  };
  CHECK_THAT(message(Misbehaviour::null_pointer), Contains("crashed: SIGSEGV"));
  CHECK_THAT(message(Misbehaviour::stop),
             Contains("STOP or exit") && Contains("the cone is upside down"));
  CHECK_THAT(message(Misbehaviour::xit), Contains("called XIT"));
  CHECK_THAT(message(Misbehaviour::nan_stress), Contains("STRESS that is not finite"));
  CHECK_THAT(message(Misbehaviour::infinite_tangent), Contains("DDSDDE that is not finite"));
  CHECK_THAT(message(Misbehaviour::nan_state), Contains("STATEV that is not finite"));
  CHECK_THAT(message(Misbehaviour::endless), Contains("did not end within 0.3 s"));
  CHECK_THAT(message(Misbehaviour::fatal_message),
             Contains("called XIT") && Contains("element 1 of CONE: M = 1.2"));
  CHECK_THAT(message(Misbehaviour::error_message), Contains("element 1 of CONE: M = 1.2"));
  CHECK_THAT(message(Misbehaviour::lopsided), Contains("not axisymmetric"));
}

TEST_CASE("a plug-in that asks for less gets less, one without a tangent still meets the control") {
  if (!umat_fixture_is_there()) return;
  const ConeInCompression expected(100, 0.01);
  for (const auto kind : {Misbehaviour::asks_for_less, Misbehaviour::no_tangent}) {
    const Material material = make_umat(umat_fixture(kind));
    const auto step = compress<Axisymmetric>(material, 100, 0.01);
    INFO(step.message);
    REQUIRE(step.outcome == StepOutcome::accepted);
    CHECK(step.state.q() / 1e3 == Approx(expected.q).epsilon(1e-6));
    if (kind == Misbehaviour::asks_for_less) CHECK(step.steps > 25);
  }
}

TEST_CASE("what a plug-in prints goes nowhere near standard output") {
  if (!umat_fixture_is_there()) return;
  const Material material = make_umat(umat_fixture(Misbehaviour::prints));
  CHECK(compress<Axisymmetric>(material, 100, 0.001).outcome == StepOutcome::accepted);
}

TEST_CASE("a set that cannot be a UMAT is refused with what would be right") {
  const auto refusal = [](ParameterSet set) -> std::string {
    try {
      make_umat(set);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  CHECK_THAT(refusal({}), Contains("umat is missing"));
  ParameterSet absent;
  absent.texts["umat"] = "libno_such_law.so";
  CHECK_THAT(refusal(absent), Contains("libno_such_law.so: cannot open shared object file"));
  ParameterSet text;
  text.folder = "tests/sim/materials";
  text.texts["umat"] = "umat_fixture.f90";
  CHECK_THAT(refusal(text), Contains("umat_fixture.f90") && Contains("ELF"));
  ParameterSet other;
  other.texts["umat"] = "libm.so.6";
  CHECK_THAT(refusal(other), Contains("has no subroutine UMAT"));
  if (!umat_fixture_is_there()) return;
  ParameterSet set = umat_fixture();
  set.texts["stress_unit"] = "mm";
  CHECK_THAT(refusal(set), Contains("stress_unit is mm"));
  set = umat_fixture();
  set.numbers["state_variables"] = 4000;
  CHECK_THAT(refusal(set), Contains("state_variables is 4000") && Contains("248"));
  set.numbers["state_variables"] = 2.5;
  CHECK_THAT(refusal(set), Contains("integer"));
  set = umat_fixture();
  set.lists["initial_state"].assign(13, 0);
  CHECK_THAT(refusal(set), Contains("initial_state has 13 values"));
  set = umat_fixture();
  set.numbers["void_ratio_index"] = 13;
  CHECK_THAT(refusal(set), Contains("void_ratio_index is 13"));
}

TEST_CASE("a library is found beside the file that names it") {
  if (!umat_fixture_is_there()) return;
  const std::filesystem::path file = kUmatFixture;
  ParameterSet set = umat_fixture();
  set.folder = file.parent_path().string();
  set.texts["umat"] = file.filename().string();
  CHECK_NOTHROW(make_umat(set));
}
