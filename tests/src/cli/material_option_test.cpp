// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/material_option.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "lab/base/bad_input.hpp"

using namespace triax;
using Catch::Contains;

namespace {

src::MaterialOptions parsed(const std::string& line) {
  CLI::App app;
  src::MaterialOptions options;
  src::add_material(app, options);
  app.parse(line);
  return options;
}

}  // namespace

TEST_CASE("the material option names a shipped set and changes its parameters") {
  const auto options =
      parsed("--material inl2/S28-general --set hardening_factor=3.5 --set poisson_ratio=0.2");
  const auto set = src::chosen_material(options);
  CHECK(set.name == "inl2/S28-general (hardening_factor = 3.5) (poisson_ratio = 0.2)");
  CHECK(set.parameters.numbers.at("hardening_factor") == 3.5);
  CHECK(set.material.axisymmetric != nullptr);
  CHECK_FALSE(options.void_ratio);
}

TEST_CASE("sets of the user's own take the place of the shipped ones") {
  const auto file = std::filesystem::temp_directory_path() / "triax_own_material.toml";
  std::ofstream(file) << "law = \"elastic\"\n[sets.mine]\nyoung_modulus_kPa = 5e4\n"
                         "poisson_ratio = 0.3\n";
  const auto set =
      src::chosen_material(parsed("--materials " + file.string() + " --material elastic/mine"));
  CHECK(set.name == "elastic/mine");
  CHECK_THROWS_WITH(
      src::chosen_material(parsed("--materials " + file.string() + " --material inl2/S28-general")),
      Contains("must be one of: elastic/mine"));
  std::filesystem::remove(file);
}

TEST_CASE("a material that is missing, unknown or given without a key is told in one line") {
  CHECK_THROWS_WITH(src::chosen_material(parsed("")), Contains("missing --material LAW/SET"));
  CHECK_THROWS_WITH(src::chosen_material(parsed("--material inl2/S28-genral")),
                    Contains("did you mean 'inl2/S28-general'?"));
  CHECK_THROWS_WITH(src::chosen_material(parsed("--material inl2/S28-general --set 3")),
                    Contains("KEY=VALUE"));
}

TEST_CASE("a void ratio is asked for with the range of the set, and bounded") {
  const auto set = src::chosen_material(parsed("--material inl2/S28-general"));
  CHECK(src::chosen_void_ratio(parsed("--void-ratio 1.086"), set) == 1.086);
  CHECK_THROWS_WITH(src::chosen_void_ratio(parsed(""), set),
                    "missing --void-ratio E; inl2/S28-general is for 0.7 to 1.2");
  for (const char* wrong :
       {"--void-ratio 0", "--void-ratio -1", "--void-ratio nan", "--void-ratio 21"})
    CHECK_THROWS_AS(src::chosen_void_ratio(parsed(wrong), set), lab::BadInput);
}
