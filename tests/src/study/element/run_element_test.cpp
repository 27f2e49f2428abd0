// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/element/run_element.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "lab/base/bad_input.hpp"
#include "lab/paths/path_reader.hpp"
#include "tests/db/temporary_folder.hpp"
#include "tests/lab/paths/path_text.hpp"

using namespace triax;

TEST_CASE("settings of a path take the material first, in whatever order they stand") {
  const testing::TemporaryFolder folder;
  const auto file = folder.file("p.toml");
  std::ofstream(file) << lab::test::kPath;
  const auto changed =
      study::described_path(file, {{"void_ratio", "1.05"}, {"material", "inl2/S28-general"}});
  CHECK(changed.material.name == "inl2/S28-general");
  CHECK(std::get<lab::TriaxialPath>(changed.path).void_ratio == 1.05);
  CHECK(study::described_path(file, {}).material.law->name == "sanisand");
  CHECK_THROWS_AS(study::described_path(file, {{"void_ratio", "-1"}}), lab::BadInput);
}

TEST_CASE("a run of a path tells its way, and keeps the increment that could not be done") {
  const auto whole = lab::read_path(lab::test::kPath, "p.toml");
  double told = 0;
  const auto result = study::run_element(whole, [&](const std::string& what, double share) {
    CHECK(what == whole.name);
    told = share;
  });
  CHECK(told > 0.9);
  CHECK(result.went_to_the_end());
  CHECK(result.failed_increment.empty());

  const auto lost = study::run_element(lab::read_path(
      lab::test::with(lab::test::with(lab::test::kPath, "axial_strain = 0.02", "q_kPa = 300"),
                      "1.0", "1.086"),
      "p.toml"));
  CHECK_FALSE(lost.went_to_the_end());
  REQUIRE_FALSE(lost.failed_increment.empty());
  CHECK(study::run_element(lab::read_path(lost.failed_increment, "q.toml")).outcome ==
        lost.outcome);
}
