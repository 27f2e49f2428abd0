// What every shipped set of every law must hold, whatever the law: a new law is covered as soon as
// its parameter file is there.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "lab/materials/material_library.hpp"
#include "sim/point/point_driver.hpp"
#include "tests/sim/materials/random_tensors.hpp"

using namespace triax;
using namespace triax::sim;

namespace {

constexpr double kPressure = 100e3;  // Pa
constexpr int kRepeats = 4;

/// The loosest void ratio of a few that the law admits at this stress.
template <class Space>
std::optional<PointState<Space>> admitted(const Law<Space>& law, const Vector<Space>& stress) {
  for (const double void_ratio : {1.05, 0.95, 0.85, 0.75, 0.65}) {
    auto state = law.start(stress, void_ratio);
    if (!law.objection(state)) return state;
  }
  return std::nullopt;
}

template <class Space>
PointState<Space> isotropic_state(const Law<Space>& law) {
  const auto state = admitted(law, isotropic<Space>(kPressure));
  REQUIRE(state);
  return *state;
}

/// Calls `check` with the set and its law wherever there is one in this space.
template <class Space, class Check>
void each_law(const Check& check) {
  int found = 0;
  for (const auto& set : lab::shipped_materials()) {
    INFO(set.name << (Space::kSize == 2 ? ", axisymmetric" : ", tensor"));
    const Law<Space>* law = set.material.template law<Space>();
    if (law == nullptr) {
      WARN(set.name << " has no form in this space: " << set.material.no_tensor);
      continue;
    }
    check(set, *law);
    ++found;
  }
  REQUIRE(found > 0);
}

/// Any rotation, or one that exchanges axes for a law whose axes are fixed.
Eigen::Matrix3d allowed_turn(const Law<Tensor>& law, const PointState<Tensor>& state,
                             test::RandomTensors& random) {
  if (!std::holds_alternative<InterpolatedForm<Tensor>>(law.response(state))) return random.turn();
  Eigen::Matrix3d exchange;
  exchange << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  return exchange;
}

/// A control, and what it is called where it fails.
struct Limit {
  const char* name;
  MixedControl<Axisymmetric> control;
};

/// Controls that no frictional law can follow to the end from p′ = 100 kPa.
std::vector<Limit> limits() {
  const double r = 1 / std::numbers::sqrt2;  // of a₃ in terms of √2 a₃
  std::vector<Limit> all;
  all.push_back({"q raised, drained", MixedControl<Axisymmetric>::stress_path(1000e3, 3000e3)});
  all.push_back({"q lowered, drained", MixedControl<Axisymmetric>::stress_path(-90e3, -270e3)});
  all.push_back({"q raised, constant p'", MixedControl<Axisymmetric>::stress_path(0, 600e3)});
  all.push_back({"p' lowered to tension", MixedControl<Axisymmetric>::stress_path(-150e3, 0)});
  MixedControl<Axisymmetric> undrained;
  undrained.stress << 1, -r, 0, 0;
  undrained.strain << 0, 0, 1, std::numbers::sqrt2;
  undrained.increment << 3000e3, 0;
  all.push_back({"q raised, undrained", undrained});
  MixedControl<Axisymmetric> axial;
  axial.stress << 1, 0, 0, r;
  axial.increment << 3000e3, 0;
  all.push_back({"axial stress raised alone", axial});
  for (const double R : {0.4, 0.7, 1.5}) {
    MixedControl<Axisymmetric> path;
    path.stress << 1, -r / R, 0, 0;
    path.strain << 0, 0, 1, 2 * R * r;
    path.increment << 3000e3, 0;
    all.push_back({R < 0.5 ? "R = 0.4" : R < 1 ? "R = 0.7" : "R = 1.5", path});
  }
  return all;
}

/// Row i of an axisymmetric control as one on a tensor whose axes 2 and 3 stay equal.
MixedControl<Tensor> widened(const MixedControl<Axisymmetric>& c) {
  MixedControl<Tensor> wide;
  for (int i = 0; i < 2; ++i) {
    wide.stress.row(i).head<3>() << c.stress(i, 0), c.stress(i, 1) / std::numbers::sqrt2,
        c.stress(i, 1) / std::numbers::sqrt2;
    wide.strain.row(i).head<3>() << c.strain(i, 0), c.strain(i, 1) / std::numbers::sqrt2,
        c.strain(i, 1) / std::numbers::sqrt2;
    wide.increment(i) = c.increment(i);
  }
  wide.strain.row(2) << 0, 1, -1, 0, 0, 0;
  for (int i = 3; i < 6; ++i) wide.strain(i, i) = 1;
  return wide;
}

/// Loose enough for hundreds of runs, fine enough to see where a path ends.
const PointTolerance kQuick{.relative = 1e-6, .smallest_step = 1e-8, .step_limit = 20000};

template <class Space>
void check_end(const Law<Space>& law, const PointState<Space>& from,
               const MixedControl<Space>& control) {
  const auto step = advance_point(law, from, control, kQuick);
  INFO("outcome " << static_cast<int>(step.outcome) << ", done " << step.done << ", culprit "
                  << step.culprit << ", " << step.message);
  CHECK(step.state.stress.allFinite());
  CHECK(step.strain_increment.allFinite());
  CHECK(std::isfinite(step.state.void_ratio));
  CHECK(step.state.memory.allFinite());
  CHECK((step.state.p() > 0 || law.carries_tension()));
  if (step.outcome == StepOutcome::accepted) {
    CHECK(step.done == 1);
    return;
  }
  CHECK_FALSE(step.message.empty());
  CHECK_FALSE(law.objection(step.state));
  if (step.outcome != StepOutcome::lost_control) return;
  REQUIRE(step.culprit >= 0);
  REQUIRE(step.culprit < Space::kSize);
  CHECK(control.increment(step.culprit) != 0);  // a row that asks for nothing can be held
  CHECK(step.done < 1);
}

}  // namespace

TEST_CASE("every law: the response turns with the axes") {
  test::RandomTensors random;
  each_law<Tensor>([&](const lab::MaterialSet&, const Law<Tensor>& law) {
    for (int i = 0; i < kRepeats; ++i) {
      Vector<Tensor> stress = random.stress<Tensor>(kPressure, 0.3);
      if (std::holds_alternative<InterpolatedForm<Tensor>>(law.response(isotropic_state(law)))) {
        stress.tail<3>().setZero();
      }
      const auto here = admitted(law, stress);
      if (!here) continue;
      const Matrix<Tensor> turned = rotation(allowed_turn(law, *here, random));
      const auto there = law.start(turned * stress, here->void_ratio);
      const Vector<Tensor> strain = 1e-3 * random.direction<Tensor>();
      const auto straight = point_rate(law, *here, MixedControl<Tensor>::strains(strain));
      const auto slanted = point_rate(law, there, MixedControl<Tensor>::strains(turned * strain));
      CHECK((turned * straight.stress - slanted.stress).norm() < 1e-8 * straight.stress.norm());
      const auto a = advance_point(law, *here, MixedControl<Tensor>::strains(strain));
      const auto b = advance_point(law, there, MixedControl<Tensor>::strains(turned * strain));
      INFO(a.message);
      CHECK(a.outcome == b.outcome);
      // Just after a reversal a law may be all but infinitely stiff: the integration's own error.
      CHECK((turned * a.state.stress - b.state.stress).norm() < 1e-4 * kPressure);
    }
  });
}

TEMPLATE_TEST_CASE("every law: the rate is homogeneous of degree one", "", Axisymmetric, Tensor) {
  test::RandomTensors random;
  each_law<TestType>([&](const lab::MaterialSet&, const Law<TestType>& law) {
    for (int i = 0; i < kRepeats; ++i) {
      const auto state = admitted(law, random.stress<TestType>(kPressure, 0.3));
      if (!state) continue;
      const Vector<TestType> strain = random.direction<TestType>();
      const auto one = point_rate(law, *state, MixedControl<TestType>::strains(strain));
      REQUIRE(one.controllable);
      for (const double scale : {1e-4, 30.0}) {
        const auto scaled =
            point_rate(law, *state, MixedControl<TestType>::strains(scale * strain));
        REQUIRE(scaled.controllable);
        CHECK((scaled.stress - scale * one.stress).norm() < 1e-9 * scale * one.stress.norm());
      }
    }
  });
}

TEST_CASE("every law: axisymmetry and the full tensor agree on triaxial paths") {
  using A = MixedControl<Axisymmetric>;
  using T = MixedControl<Tensor>;
  each_law<Tensor>([&](const lab::MaterialSet& set, const Law<Tensor>& law) {
    const auto& triaxial = *set.material.axisymmetric;
    const std::pair<A, T> paths[] = {{A::strain_path(0.003), T::strain_path(0.003)},
                                     {A::strain_path(-0.003), T::strain_path(-0.003)},
                                     {A::strain_path(0.003, 0.5), T::strain_path(0.003, 0.5)},
                                     {A::drained_compression(0.003), T::drained_compression(0.003)},
                                     {A::stress_path(-10e3, 10e3), T::stress_path(-10e3, 10e3)}};
    for (const auto& [narrow, wide] : paths) {
      const auto a = advance_point(triaxial, isotropic_state(triaxial), narrow);
      const auto t = advance_point(law, isotropic_state(law), wide);
      INFO(a.message << " / " << t.message);
      CHECK(a.outcome == t.outcome);
      CHECK((as_tensor(a.state.stress) - t.state.stress).norm() < 1e-6 * kPressure);
      CHECK(a.state.void_ratio == Approx(t.state.void_ratio).margin(1e-9));
    }
  });
}

TEST_CASE("laws that promise a symmetric tangent have one") {
  const std::set<std::string> symmetric = {"elastic", "cam_clay"};
  test::RandomTensors random;
  int checked = 0;
  each_law<Tensor>([&](const lab::MaterialSet& set, const Law<Tensor>& law) {
    if (!symmetric.contains(set.law->name)) return;
    const auto state = admitted(law, random.stress<Tensor>(kPressure, 0.3));
    REQUIRE(state);
    const auto response = law.response(*state);
    const int mechanisms = std::get<StiffnessForm<Tensor>>(response).mechanisms;
    for (unsigned loading = 0; loading < 1U << mechanisms; ++loading) {
      const Matrix<Tensor> tangent = test::tangent_of(response, loading);
      CHECK((tangent - tangent.transpose()).norm() < 1e-10 * tangent.norm());
      ++checked;
    }
  });
  CHECK(checked >= 6);
}

TEST_CASE("every law, every control: a path beyond the limit ends in words and finite numbers") {
  for (const Limit& limit : limits()) {
    INFO(limit.name);
    each_law<Axisymmetric>([&](const lab::MaterialSet&, const Law<Axisymmetric>& law) {
      check_end(law, isotropic_state(law), limit.control);
      // The same after some shear, so that the memory is not that of the start.
      const auto sheared = advance_point(law, isotropic_state(law),
                                         MixedControl<Axisymmetric>::drained_compression(0.002));
      if (sheared.outcome == StepOutcome::accepted) check_end(law, sheared.state, limit.control);
    });
    each_law<Tensor>([&](const lab::MaterialSet&, const Law<Tensor>& law) {
      check_end(law, isotropic_state(law), widened(limit.control));
    });
  }
}

TEST_CASE("every law: plane strain, simple shear and a lone shear stress end in words too") {
  test::RandomTensors random;
  each_law<Tensor>([&](const lab::MaterialSet&, const Law<Tensor>& law) {
    for (const double size : {0.05, -0.05}) {
      Vector<Tensor> strain = Vector<Tensor>::Zero();
      strain << size, 0, -0.5 * size, 0, 0, 0;
      check_end(law, isotropic_state(law), MixedControl<Tensor>::strains(strain));
    }
    if (std::holds_alternative<InterpolatedForm<Tensor>>(law.response(isotropic_state(law))))
      return;
    Vector<Tensor> shear = Vector<Tensor>::Zero();
    shear(3) = 0.05;
    check_end(law, isotropic_state(law), MixedControl<Tensor>::strains(shear));
    shear(3) = 500e3;
    check_end(law, isotropic_state(law), MixedControl<Tensor>::stresses(shear));
  });
}
