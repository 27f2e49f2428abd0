#include "lab/programmes/material_library.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "lab/records/bad_input.hpp"
#include "tests/sim/materials/parameter_sets.hpp"

using namespace triax::lab;
using Catch::Contains;

TEST_CASE("the shipped sets are the ones that the law was checked with") {
  for (const auto& [name, expected] :
       {std::pair{"sanisand/S28-general", triax::sim::test::s28_general()},
        std::pair{"sanisand/Toyoura-DM04", triax::sim::test::toyoura()}}) {
    const auto found = find_material(name).parameters;
    INFO(name);
    CHECK(found.shear_modulus_factor == expected.shear_modulus_factor);
    CHECK(found.poisson_ratio == expected.poisson_ratio);
    CHECK(found.critical_stress_ratio == expected.critical_stress_ratio);
    CHECK(found.extension_ratio == expected.extension_ratio);
    CHECK(found.critical_void_ratio == expected.critical_void_ratio);
    CHECK(found.critical_slope == expected.critical_slope);
    CHECK(found.critical_exponent == expected.critical_exponent);
    CHECK(found.yield_radius == expected.yield_radius);
    CHECK(found.hardening_factor == expected.hardening_factor);
    CHECK(found.hardening_void_ratio_factor == expected.hardening_void_ratio_factor);
    CHECK(found.bounding_exponent == expected.bounding_exponent);
    CHECK(found.dilatancy_factor == expected.dilatancy_factor);
    CHECK(found.dilatancy_exponent == expected.dilatancy_exponent);
    CHECK(found.fabric_limit == expected.fabric_limit);
    CHECK(found.fabric_rate == expected.fabric_rate);
    CHECK(found.atmospheric_pressure_pa == expected.atmospheric_pressure_pa);
  }
  CHECK_FALSE(find_material("sanisand/S28-general").source.empty());
}

TEST_CASE("an unknown material is refused with the nearest known one") {
  CHECK_THROWS_WITH(find_material("sanisand/S28-genral"),
                    Contains("did you mean 'sanisand/S28-general'?"));
  CHECK_THROWS_AS(find_material(""), BadInput);
}

TEST_CASE("a user's file is held to the same rules, with its line") {
  CHECK_THROWS_WITH(
      read_materials("law = \"sanisand\"\n[sets.mine]\nfabric_rat = 3\n", "my.toml"),
      Contains("my.toml:2") && Contains("[sets.mine]: shear_modulus_factor is missing"));
  CHECK_THROWS_WITH(read_materials("law = \"camclay\"\n", "my.toml"), Contains("my.toml:1"));
  CHECK_THROWS_AS(read_materials("law = ", "my.toml"), BadInput);
  CHECK_THROWS_AS(read_materials("law = \"sanisand\"\n[sets]\n", "my.toml"), BadInput);
}
