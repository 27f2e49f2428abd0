#include "src/probe/probe_states.hpp"

#include <catch2/catch.hpp>
#include <fstream>

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
struct Asked {
  src::ProbeReport report;
  std::vector<study::StateToProbe<Space>> states;
  explicit Asked(const src::ProbeOptions& options) {
    report.material = src::material_of(options);
    states = src::states_to_probe<Space>(options, report);
  }
};

src::ProbeOptions given(const std::string& material = "inl2/S28-general") {
  src::ProbeOptions options;
  options.material.name = material;
  options.material.void_ratio = 1.086;
  return options;
}

src::ProbeOptions along(const testing::TemporaryFolder& folder, const std::string& text) {
  src::ProbeOptions options;
  options.path = folder.file("p.toml");
  std::ofstream(options.path) << text;
  return options;
}

}  // namespace

TEST_CASE("p' with eta or q, and principal stresses, are the same states in both spaces") {
  auto options = given();
  options.p_kPa = 70;
  options.eta = {0.5, 0.6};
  const Asked<Axisymmetric> triaxial(options);
  REQUIRE(triaxial.states.size() == 2);
  CHECK(triaxial.report.many);
  CHECK(triaxial.states[1].state.p() == Approx(70e3));
  CHECK(triaxial.states[1].state.q() == Approx(42e3));
  CHECK(triaxial.states[1].state.void_ratio == 1.086);
  const Asked<Tensor> tensor(options);
  CHECK(tensor.states[1].state.q() == Approx(42e3));
  CHECK(tensor.states[1].state.stress(1) == tensor.states[1].state.stress(2));

  options.eta.clear();
  options.q_kPa = {42};
  const Asked<Axisymmetric> by_q(options);
  CHECK_FALSE(by_q.report.many);
  CHECK(by_q.states[0].state.stress.isApprox(triaxial.states[1].state.stress));

  auto principal = given();
  principal.stress_kPa = {98, 56};
  CHECK(Asked<Axisymmetric>(principal).states[0].state.stress.isApprox(
      triaxial.states[1].state.stress));
  principal.stress_kPa = {98, 80, 56};
  const auto stress = Asked<Tensor>(principal).states[0].state.stress;
  CHECK(stress(1) == 80e3);
  CHECK(stress(2) == 56e3);
}

TEST_CASE("the end of a path is the state that the path runner ends at, memory included") {
  const testing::TemporaryFolder folder;
  const Asked<Axisymmetric> asked(along(folder, lab::test::kPath));
  REQUIRE(asked.states.size() == 1);
  const auto& set = asked.report.material;
  const auto description = lab::read_path(lab::test::kPath, "p.toml");
  const auto run =
      sim::run_path(*set.material.axisymmetric, std::get<lab::TriaxialPath>(description.path));
  const auto& state = asked.states[0].state;
  CHECK(state.stress.isApprox(run.last.stress, 1e-12));
  REQUIRE(state.memory.size() == static_cast<Eigen::Index>(run.last.memory.size()));
  CHECK(state.memory.size() > 0);
  for (Eigen::Index i = 0; i < state.memory.size(); ++i)
    CHECK(state.memory(i) == run.last.memory[static_cast<std::size_t>(i)]);
  CHECK(asked.states[0].from_path);
  CHECK(asked.states[0].axial_strain == Approx(0.02));
  CHECK_FALSE(asked.report.many);
  CHECK(asked.report.path == description.name);
}

TEST_CASE("every N-th row of a path, from its start; as a tensor the same stresses") {
  const testing::TemporaryFolder folder;
  auto options = along(folder, lab::test::kPath);
  const auto description = lab::read_path(lab::test::kPath, "p.toml");
  const auto rows = std::get<lab::TriaxialPath>(description.path).segments[0].rows;
  options.every = 2;
  const Asked<Axisymmetric> triaxial(options);
  CHECK(triaxial.report.many);
  CHECK(triaxial.states.size() == static_cast<std::size_t>(rows / 2 + 1 + rows % 2));
  options.every = 3;  // does not divide the rows: the last one is there all the same
  const Asked<Axisymmetric> thirds(options);
  CHECK(thirds.states.back().axial_strain == triaxial.states.back().axial_strain);
  CHECK(thirds.states.back().axial_strain == Approx(0.02));
  CHECK(thirds.states[1].passed.size() == 4);
  options.every = 2;
  CHECK(triaxial.states[0].axial_strain == 0.0);
  const Asked<Tensor> tensor(options);
  REQUIRE(tensor.states.size() == triaxial.states.size());
  for (std::size_t i = 0; i < tensor.states.size(); ++i) {
    const auto expected = sim::as_tensor(triaxial.states[i].state.stress);
    CHECK(tensor.states[i].state.stress.isApprox(expected, 1e-5));
  }
}

TEST_CASE("material and void ratio of the command line take the place of the path's") {
  const testing::TemporaryFolder folder;
  auto options = along(folder, lab::test::kPath);
  CHECK(src::material_of(options).law->name == "sanisand");
  options.material.name = "inl2/S28-general";
  options.material.void_ratio = 0.9;
  options.every = 1;
  const Asked<Axisymmetric> asked(options);
  CHECK(asked.report.material.name == "inl2/S28-general");
  CHECK(asked.states[0].state.void_ratio == 0.9);
  options.material.name.clear();
  options.material.sets = {"hardening_factor=2"};
  CHECK(src::material_of(options).name != "sanisand/S28-general");
}

TEST_CASE("a path that loses control ends with a warning, and its last state") {
  const testing::TemporaryFolder folder;
  const auto text = lab::test::with(
      lab::test::with(lab::test::kPath, "axial_strain = 0.02", "q_kPa = 300"), "1.0", "1.086");
  const Asked<Axisymmetric> asked(along(folder, text));
  REQUIRE(asked.states.size() == 1);
  REQUIRE(asked.report.warnings.size() == 1);
  CHECK(asked.report.warnings[0].find("stopped early") != std::string::npos);
}

TEST_CASE("what cannot be probed in the plane, or is not there, is bad input") {
  const testing::TemporaryFolder folder;
  auto norsand = given("norsand/S28-MT");
  norsand.p_kPa = 70;
  norsand.eta = {0.5};
  CHECK_THROWS_WITH(Asked<Tensor>(norsand), Catch::Contains("cannot be probed in this plane"));
  const auto tensor =
      lab::test::with(lab::test::kPath, "p_eff_kPa = 100.0", "stress_kPa = [100, 90, 80, 0, 0, 0]");
  CHECK_THROWS_WITH(Asked<Axisymmetric>(along(folder, tensor)),
                    Catch::Contains("--plane plane-strain"));
  auto nowhere = given();
  nowhere.tests = {"26"};
  nowhere.db = folder.file("none.db");
  CHECK_THROWS_AS(Asked<Axisymmetric>(nowhere), lab::BadInput);
  auto hollow = given();
  hollow.material.void_ratio.reset();
  hollow.p_kPa = 70;
  hollow.eta = {0.5};
  CHECK_THROWS_WITH(Asked<Axisymmetric>(hollow), Catch::Contains("--void-ratio"));
}

TEST_CASE("the files that are read are known, so that none is overwritten") {
  const testing::TemporaryFolder folder;
  const auto options = along(folder, lab::test::kPath);
  CHECK(src::files_read(options) == std::vector<std::string>{options.path});
  auto test = given();
  test.tests = {"26"};
  test.material.file = "mine.toml";
  const auto files = src::files_read(test);
  CHECK(files.front() == "triax.db");
  CHECK(files.back() == "mine.toml");
}
