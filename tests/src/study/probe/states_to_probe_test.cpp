// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/states_to_probe.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/paths/path_reader.hpp"
#include "sim/point/path_runner.hpp"
#include "tests/db/temporary_folder.hpp"
#include "tests/lab/paths/path_text.hpp"

using namespace triax;
using sim::Axisymmetric;
using sim::Tensor;

namespace {

template <class Space>
study::StatesToProbe<Space> given(std::vector<Eigen::Vector3d> stress_kPa,
                                  const std::string& material = "inl2/S28-general") {
  return study::states_to_probe<Space>(lab::find_material(material),
                                       study::GivenStates{std::move(stress_kPa), 1.086});
}

template <class Space>
study::StatesToProbe<Space> along(const std::string& text, std::optional<int> every = {}) {
  auto path = lab::read_path(text, "p.toml");
  const auto material = path.material;
  return study::states_to_probe<Space>(material, study::StatesOfPath{std::move(path), every});
}

}  // namespace

TEST_CASE("stresses along three axes are the same states in both spaces") {
  const std::vector<Eigen::Vector3d> stress = {study::triaxial_stress(70, 35),
                                               study::triaxial_stress(70, 42)};
  const auto triaxial = given<Axisymmetric>(stress);
  REQUIRE(triaxial.states.size() == 2);
  CHECK(triaxial.many);
  CHECK(triaxial.states[1].state.p() == Approx(70e3));
  CHECK(triaxial.states[1].state.q() == Approx(42e3));
  CHECK(triaxial.states[1].state.void_ratio == 1.086);
  const auto tensor = given<Tensor>(stress);
  CHECK(tensor.states[1].state.q() == Approx(42e3));
  CHECK(tensor.states[1].state.stress(1) == tensor.states[1].state.stress(2));

  const auto principal = given<Tensor>({{98, 80, 56}});
  CHECK_FALSE(principal.many);
  CHECK(principal.states[0].state.stress(1) == 80e3);
  CHECK(principal.states[0].state.stress(2) == 56e3);
}

TEST_CASE("the end of a path is the state that the path runner ends at, memory included") {
  const auto found = along<Axisymmetric>(lab::test::kPath);
  REQUIRE(found.states.size() == 1);
  const auto description = lab::read_path(lab::test::kPath, "p.toml");
  const auto run = sim::run_path(*description.material.material.axisymmetric,
                                 std::get<lab::TriaxialPath>(description.path));
  const auto& state = found.states[0].state;
  CHECK(state.stress.isApprox(run.last.stress, 1e-12));
  REQUIRE(state.memory.size() == static_cast<Eigen::Index>(run.last.memory.size()));
  CHECK(state.memory.size() > 0);
  for (Eigen::Index i = 0; i < state.memory.size(); ++i)
    CHECK(state.memory(i) == run.last.memory[static_cast<std::size_t>(i)]);
  CHECK(found.states[0].from_path);
  CHECK(found.states[0].axial_strain == Approx(0.02));
  CHECK(found.states[0].name == "ε₁ 2.000 %");
  CHECK_FALSE(found.many);
  CHECK(found.path == description.name);
}

TEST_CASE("every N-th row of a path, from its start; as a tensor the same stresses") {
  const auto description = lab::read_path(lab::test::kPath, "p.toml");
  const auto rows = std::get<lab::TriaxialPath>(description.path).segments[0].rows;
  const auto triaxial = along<Axisymmetric>(lab::test::kPath, 2);
  CHECK(triaxial.many);
  CHECK(triaxial.states.size() == static_cast<std::size_t>(rows / 2 + 1 + rows % 2));
  // Three does not divide the rows: the last one is there all the same.
  const auto thirds = along<Axisymmetric>(lab::test::kPath, 3);
  CHECK(thirds.states.back().axial_strain == triaxial.states.back().axial_strain);
  CHECK(thirds.states.back().axial_strain == Approx(0.02));
  CHECK(thirds.states[1].passed.size() == 4);
  CHECK(triaxial.states[0].axial_strain == 0.0);
  const auto tensor = along<Tensor>(lab::test::kPath, 2);
  REQUIRE(tensor.states.size() == triaxial.states.size());
  for (std::size_t i = 0; i < tensor.states.size(); ++i) {
    const auto expected = sim::as_tensor(triaxial.states[i].state.stress);
    CHECK(tensor.states[i].state.stress.isApprox(expected, 1e-5));
  }
}

TEST_CASE("a path that loses control ends with a warning, and its last state") {
  const auto found = along<Axisymmetric>(lab::test::with(
      lab::test::with(lab::test::kPath, "axial_strain = 0.02", "q_kPa = 300"), "1.0", "1.086"));
  REQUIRE(found.states.size() == 1);
  REQUIRE(found.warnings.size() == 1);
  CHECK(found.warnings[0].find("stopped early") != std::string::npos);
}

TEST_CASE("the way along a path is told under its name") {
  auto path = lab::read_path(lab::test::kPath, "p.toml");
  const auto material = path.material;
  std::string told;
  double share = 0;
  study::states_to_probe<Axisymmetric>(material, study::StatesOfPath{path, {}},
                                       [&](const std::string& what, double done) {
                                         told = what;
                                         CHECK(done >= share);
                                         share = done;
                                       });
  CHECK(told == path.name);
  CHECK(share > 0.9);
}

TEST_CASE("what cannot be probed in a space, or is not there, is bad input") {
  CHECK_THROWS_WITH(given<Tensor>({{98, 56, 56}}, "norsand/S28-MT"),
                    Catch::Contains("cannot be probed in this plane"));
  const auto tensor =
      lab::test::with(lab::test::kPath, "p_eff_kPa = 100.0", "stress_kPa = [100, 90, 80, 0, 0, 0]");
  CHECK_THROWS_WITH(along<Axisymmetric>(tensor), Catch::Contains("plane strain"));
  const testing::TemporaryFolder folder;
  study::MeasuredStates nowhere{.db = folder.file("none.db"), .tests = {"26"}};
  CHECK_THROWS_AS(
      study::states_to_probe<Axisymmetric>(lab::find_material("inl2/S28-general"), nowhere),
      lab::BadInput);
}
