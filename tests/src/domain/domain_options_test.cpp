// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/domain/domain_options.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::study;
using Catch::Contains;

namespace {

DomainOptions loose() {
  DomainOptions o;
  o.material.void_ratio = 1.0;
  return o;
}

/// What check_domain_options says of these arguments; empty: nothing.
std::string refusal(std::vector<std::string> arguments) {
  CLI::App app;
  DomainOptions o;
  add_domain_options(app, o);
  std::reverse(arguments.begin(), arguments.end());
  app.parse(arguments);
  try {
    check_domain_options(app, o);
  } catch (const lab::BadInput& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("beside --merge only what does not compute is taken") {
  CHECK(refusal({"--merge", "a", "--output", "b", "--test", "1", "--db", "c", "--json"}).empty());
  CLI::App app;
  DomainOptions o;
  add_domain_options(app, o);
  int refused = 0;
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_name();
    if (name == "--help" || name == "--merge" || name == "--output" || name == "--test" ||
        name == "--db" || name == "--format" || name == "--json")
      continue;
    std::vector<std::string> arguments = {"--merge", "a", name};
    if (option->get_items_expected_min() > 0)
      arguments.push_back(name == "--plane" ? "plane-strain" : "1");
    INFO(name);
    CHECK_THAT(refusal(arguments), Contains(name + " cannot be used with --merge"));
    ++refused;
  }
  CHECK(refused >= 10);
}

TEST_CASE("a piece goes to a file") {
  CHECK_THAT(refusal({"--piece", "1/2"}), Contains("--piece needs --output"));
  CHECK_THAT(refusal({"--piece", "1/2", "--output", "x", "--json"}), Contains("--json"));
}

TEST_CASE("the grid says which criteria were looked for, and refuses what a law cannot give") {
  DomainOptions o = loose();
  const auto inl2 = lab::find_material("inl2/S28-general");
  CHECK(chosen_grid(o, inl2).looks_for("determinant"));
  CHECK_FALSE(chosen_grid(o, inl2).looks_for("localisation"));
  o.criteria = {"localisation"};
  CHECK(chosen_grid(o, inl2).looks_for("localisation"));
  CHECK_THROWS_WITH(chosen_grid(o, lab::find_material("norsand/S28-MT")),
                    Contains("--localisation needs the full tensor"));
  o.p = "50:60/3";
  CHECK(chosen_grid(o, inl2).p_to_kPa == 60);
  CHECK(chosen_grid(o, inl2).columns == 3);
  o.p = "50:60:2";
  CHECK(chosen_grid(o, inl2).columns == 6);
  o.p = "50:60:3";
  CHECK_THROWS_WITH(chosen_grid(o, inl2), Contains("does not reach its end"));
  o.p = "50";
  CHECK_THROWS_WITH(chosen_grid(o, inl2), Contains("FROM:TO/COUNT"));
}
