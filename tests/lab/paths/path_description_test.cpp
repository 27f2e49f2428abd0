// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/path_description.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/paths/path_reader.hpp"
#include "tests/lab/paths/path_text.hpp"

using namespace triax::lab;
using namespace triax;
using Catch::Contains;

TEST_CASE("settings change the start, the tolerance, the material and its parameters") {
  auto description = read_path(test::kPath, "p.toml");
  change_setting(description, "void_ratio", "0.9");
  change_setting(description, "p_eff_kPa", "250");
  change_setting(description, "tolerance", "1e-6");
  change_setting(description, "material", "sanisand/Toyoura-DM04");
  change_setting(description, "poisson_ratio", "0.2");
  CHECK_NOTHROW(check_start(description));
  const auto& path = std::get<TriaxialPath>(description.path);
  CHECK(path.void_ratio == 0.9);
  CHECK(sim::mean_stress<sim::Axisymmetric>(path.stress) == Approx(250e3));
  CHECK(description.tolerance == 1e-6);
  CHECK(description.material.parameters.numbers.at("poisson_ratio") == 0.2);
  CHECK(description.material.parameters.numbers.at("critical_void_ratio") == 0.934);
  CHECK(description.material_name == "sanisand/Toyoura-DM04");
  REQUIRE(description.parameters.size() == 1);
}

TEST_CASE("settings that are none, and values that cannot be, are refused") {
  auto description = read_path(test::kPath, "p.toml");
  const auto refused = [&](const char* key, const char* value, const char* because) {
    CHECK_THROWS_WITH(change_setting(description, key, value), Contains(because));
  };
  refused("voidratio", "1", "did you mean 'void_ratio'?");
  refused("void_ratio", "abc", "must be a number, 0.05 to 20");
  refused("void_ratio", "1.0x", "must be a number");
  refused("void_ratio", "-1", "must be a number");
  refused("p_eff_kPa", "inf", "must be a number");
  refused("material", "sanisand", "unknown material");
  refused("poisson_ratio", "0.7", "must be");
}

TEST_CASE("a start that the law refuses, or with another law's memory, is bad input") {
  auto description = read_path(test::kPath, "p.toml");
  change_setting(description, "void_ratio", "9");
  CHECK_THROWS_WITH(check_start(description), Contains("out of range for"));
  auto remembered = read_path(
      test::with(test::kPath, "void_ratio = 1.0", "void_ratio = 1.0\nmemory = [1, 2]"), "p.toml");
  CHECK_THROWS_WITH(check_start(remembered), Contains("memory has 2 values"));
  CHECK_THROWS_AS(change_setting(remembered, "p_eff_kPa", "50"), BadInput);
}
