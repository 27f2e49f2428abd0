// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/probe_request.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "lab/base/bad_input.hpp"
#include "tests/db/temporary_folder.hpp"
#include "tests/lab/paths/path_text.hpp"

using namespace triax;

namespace {

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

TEST_CASE("p' with eta or q, and principal stresses, are stresses along three axes") {
  const auto stresses = [](const src::ProbeOptions& options) {
    return std::get<study::GivenStates>(src::probe_request(options).states).stress_kPa;
  };
  auto options = given();
  options.p_kPa = 70;
  options.eta = {0.5, 0.6};
  REQUIRE(stresses(options).size() == 2);
  CHECK(stresses(options)[1].isApprox(Eigen::Vector3d(98, 56, 56)));
  options.eta.clear();
  options.q_kPa = {42};
  CHECK(stresses(options).at(0).isApprox(Eigen::Vector3d(98, 56, 56)));
  auto principal = given();
  principal.stress_kPa = {98, 56};
  CHECK(stresses(principal).at(0) == Eigen::Vector3d(98, 56, 56));
  principal.plane = "plane-strain";
  principal.stress_kPa = {98, 80, 56};
  CHECK(stresses(principal).at(0) == Eigen::Vector3d(98, 80, 56));
}

TEST_CASE("figures are asked for where they are to be written") {
  auto options = given();
  options.p_kPa = 70;
  options.eta = {0.5};
  CHECK_FALSE(src::probe_request(options).figures);
  options.output = "x";
  CHECK(src::probe_request(options).figures);
}

TEST_CASE("material and void ratio of the command line take the place of the path's") {
  const testing::TemporaryFolder folder;
  auto options = along(folder, lab::test::kPath);
  CHECK(src::probe_request(options).material.law->name == "sanisand");
  options.material.name = "inl2/S28-general";
  options.material.void_ratio = 0.9;
  options.every = 1;
  const auto request = src::probe_request(options);
  CHECK(request.material.name == "inl2/S28-general");
  const auto& wanted = std::get<study::StatesOfPath>(request.states);
  CHECK(wanted.path.material.name == "inl2/S28-general");
  CHECK(std::get<lab::TriaxialPath>(wanted.path.path).void_ratio == 0.9);
  CHECK(wanted.every == 1);
  options.material.name.clear();
  options.material.sets = {"hardening_factor=2"};
  CHECK(src::probe_request(options).material.name != "sanisand/S28-general");
}

TEST_CASE("a test is asked for at its collapse unless another reading is named") {
  auto options = given();
  options.tests = {"26", "27"};
  options.db = "some.db";
  const auto wanted = std::get<study::MeasuredStates>(src::probe_request(options).states);
  CHECK(wanted.tests == options.tests);
  CHECK(wanted.db == "some.db");
  CHECK(wanted.at == "collapse");
  CHECK(wanted.void_ratio == 1.086);
  options.at = "peak";
  CHECK(std::get<study::MeasuredStates>(src::probe_request(options).states).at == "peak");
}

TEST_CASE("a request that cannot be made is bad input in the words of the options") {
  const testing::TemporaryFolder folder;
  const auto tensor =
      lab::test::with(lab::test::kPath, "p_eff_kPa = 100.0", "stress_kPa = [100, 90, 80, 0, 0, 0]");
  CHECK_THROWS_WITH(src::probe_request(along(folder, tensor)),
                    Catch::Contains("--plane plane-strain"));
  auto hollow = given();
  hollow.material.void_ratio.reset();
  hollow.p_kPa = 70;
  hollow.eta = {0.5};
  CHECK_THROWS_WITH(src::probe_request(hollow), Catch::Contains("--void-ratio"));
}

TEST_CASE("space and strain paths are asked for with their own numbers") {
  auto options = given();
  options.p_kPa = 100;
  options.strain_paths = {0.7, 1.0};
  const auto paths = src::strain_paths_request(options);
  CHECK(paths.p == 100e3);
  CHECK(paths.R == options.strain_paths);
  CHECK(paths.void_ratio == 1.086);
  CHECK(paths.axial_strain == src::kUsualAxialStrain);
  options.strain_paths.clear();
  options.eta = {0.5};
  options.plane = "3d";
  options.step_deg = 15;
  CHECK(src::sphere_request(options).probing.rings == 12);
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
