// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/materials/material_library.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <string>

#include "lab/base/bad_input.hpp"
#include "sim/materials/sanisand.hpp"
#include "tests/sim/materials/hypoplastic_sets.hpp"
#include "tests/sim/materials/norsand_sets.hpp"
#include "tests/sim/materials/parameter_sets.hpp"

using namespace triax::lab;
using Catch::Contains;

TEST_CASE("the shipped sets are the ones that the law was checked with") {
  for (const auto& [name, expected] :
       {std::pair{"sanisand/S28-general", triax::sim::test::s28_general()},
        std::pair{"sanisand/Toyoura-DM04", triax::sim::test::toyoura()}}) {
    const auto found =
        triax::sim::parameters_from(find_material(name).parameters, triax::sim::sanisand_table());
    for (const auto& row : triax::sim::sanisand_table()) {
      INFO(name << " " << row.description.key);
      CHECK(found.*row.member == expected.*row.member);
    }
  }
  CHECK_FALSE(find_material("sanisand/S28-general").source.empty());
}

TEST_CASE("the shipped sets of hypoplasticity and NorSand are those that were checked") {
  const auto check = [](const char* name, const auto& expected, const auto& table) {
    const auto found = triax::sim::parameters_from(find_material(name).parameters, table);
    for (const auto& row : table) {
      INFO(name << " " << row.description.key);
      // The published angle of one set is rounded in its file.
      CHECK(found.*row.member == Approx(expected.*row.member).epsilon(1e-7));
    }
  };
  using namespace triax::sim;
  namespace test = triax::sim::test;
  const auto& hypoplastic = hypoplastic_table();
  check("hypoplastic/HG99", test::hostun_hg99(), hypoplastic);
  check("hypoplastic/Schranz", test::hostun_schranz(), hypoplastic);
  check("hypoplastic/S28-MT", test::hostun_moist_tamped(), hypoplastic);
  check("hypoplastic/S28-MT-IGS", test::with_intergranular_strain(test::hostun_moist_tamped()),
        hypoplastic);
  check("norsand/Nerlerk-270", test::nerlerk(), norsand_table());
  check("norsand/Nerlerk-270-drained", test::nerlerk_drained(), norsand_table());
  check("norsand/S28-MT", test::hostun_norsand(), norsand_table());
}

TEST_CASE("the interpolated laws stand on the same SANISAND but for its hardening and fabric") {
  for (const std::string set : {"S28-general", "S28-loose"}) {
    const auto base = find_material("sanisand/" + set).parameters.numbers;
    REQUIRE(base.size() == 16);
    for (const std::string law : {"inl2", "octolinear"}) {
      const auto found = find_material(law + "/" + set);
      CHECK(found.parameters.texts.at("base") == "sanisand");
      CHECK(found.parameters.numbers.size() == base.size());
      for (const auto& [key, value] : base) {
        INFO(found.name << " " << key);
        const double own = found.parameters.numbers.at(key);
        if (key == "fabric_limit" || key == "fabric_rate")
          CHECK(own == 0);  // without fabric
        else if (key == "hardening_factor")
          CHECK(own > value);
        else
          CHECK(own == value);
      }
    }
  }
}

TEST_CASE("every shipped set says what it is, where it comes from and how far it reaches") {
  for (const auto& set : shipped_materials()) {
    INFO(set.name);
    CHECK_FALSE(set.description.empty());
    CHECK_FALSE(set.source.empty());
    CHECK_FALSE(set.range.empty());
    CHECK(set.material.axisymmetric != nullptr);
    CHECK((set.material.tensor != nullptr || !set.material.no_tensor.empty()));
  }
}

TEST_CASE("one parameter can be changed, and the name says so") {
  const auto set = with_parameter(find_material("sanisand/S28-general"), "hardening_factor", "1.5");
  CHECK(set.name == "sanisand/S28-general (hardening_factor = 1.5)");
  CHECK(set.parameters.numbers.at("hardening_factor") == 1.5);
  CHECK_THROWS_WITH(with_parameter(set, "hardning_factor", "1"), Contains("hardening_factor"));
  CHECK_THROWS_WITH(with_parameter(set, "hardening_factor", "-1"), Contains("must be above 0"));
  CHECK_THROWS_AS(with_parameter(set, "hardening_factor", "one"), BadInput);
}

TEST_CASE("an unknown material is refused with the nearest known one") {
  CHECK_THROWS_WITH(find_material("sanisand/S28-genral"),
                    Contains("did you mean 'sanisand/S28-general'?"));
  CHECK_THROWS_AS(find_material(""), BadInput);
}

TEST_CASE("a parameter that chooses the others leaves none of them, nor their range") {
  const auto set =
      with_parameter(find_material("inl2/S28-general"), "base", "cam_clay/Hostun-like");
  CHECK(set.parameters.numbers.empty());
  CHECK(set.range.empty());
  CHECK_FALSE(p_eff_outside(set, 1e9));
  CHECK_THAT(set.material.based_on, Contains("cam_clay/Hostun-like by probing"));
  CHECK_THROWS_WITH(with_parameter(set, "hardening_factor", "2"), Contains("is not used"));
}

TEST_CASE("a user's file is held to the same rules, with its line") {
  CHECK_THROWS_WITH(read_materials("law = \"sanisand\"\n[sets.mine]\nfabric_rat = 3\n", "my.toml"),
                    Contains("my.toml:3") && Contains("did you mean 'fabric_rate'?"));
  CHECK_THROWS_WITH(
      read_materials("law = \"sanisand\"\n[sets.mine]\nfabric_rate = 3\n", "my.toml"),
      Contains("my.toml:2") && Contains("sanisand/mine: shear_modulus_factor is missing"));
  CHECK_THROWS_WITH(read_materials("law = \"camclay\"\n", "my.toml"), Contains("my.toml:1"));
  CHECK_THROWS_AS(read_materials("law = ", "my.toml"), BadInput);
  CHECK_THROWS_AS(read_materials("law = \"sanisand\"\n[sets]\n", "my.toml"), BadInput);
}

TEST_CASE("ranges of sets are numbers too, the ones of the words") {
  int with_both = 0;
  for (const auto& set : shipped_materials()) {
    INFO(set.name << ": " << set.range);
    CHECK(set.p_eff_range_kPa.has_value() == (set.range.find("p' ") != std::string::npos));
    for (const auto& range : {set.p_eff_range_kPa, set.void_ratio_range})
      if (range) CHECK(range->low < range->high);
    if (set.p_eff_range_kPa)
      CHECK_THAT(set.range,
                 Contains("p' " + fmt::format("{:g} to {:g} kPa", set.p_eff_range_kPa->low,
                                              set.p_eff_range_kPa->high)));
    with_both += set.p_eff_range_kPa && set.void_ratio_range;
  }
  CHECK(with_both >= 14);
  const auto toyoura = find_material("sanisand/Toyoura-DM04");
  CHECK(toyoura.void_ratio_range->low == 0.60);
  CHECK(toyoura.void_ratio_range->high == 0.98);
}

TEST_CASE("a state outside the range of its set is told, with number, range and set") {
  const auto set = find_material("inl2/S28-general");
  CHECK_FALSE(p_eff_outside(set, 10e3));
  CHECK_FALSE(p_eff_outside(set, 1000e3));
  CHECK(p_eff_outside(set, 3.2e3) ==
        "p' is 3.2 kPa, outside the range 10 to 1000 kPa of inl2/S28-general");
  CHECK(p_eff_outside(set, 9.99996e3) ==
        "p' is 9.99996 kPa, outside the range 10 to 1000 kPa of inl2/S28-general");
  CHECK_FALSE(void_ratio_outside(set, 1.192));  // the loosest test that it was calibrated on
  CHECK(void_ratio_outside(set, 0.65) ==
        "void ratio is 0.65, outside the range 0.7 to 1.2 of inl2/S28-general");
  CHECK(void_ratio_outside(find_material("norsand/S28-true-state"), 1.3) ==
        "void ratio is 1.3, outside the range up to 1.2 of norsand/S28-true-state");
  CHECK_FALSE(p_eff_outside(find_material("elastic/linear"), 1e9));
}

TEST_CASE("a range that is none is refused with its line") {
  for (const char* range : {"[10]", "[10, 5]", "[-1, 5]", "[1, 2, 3]"}) {
    INFO(range);
    CHECK_THROWS_WITH(
        read_materials(fmt::format("law = \"elastic\"\n[sets.x]\nyoung_modulus_kPa = 1.0\n"
                                   "poisson_ratio = 0.2\np_eff_range_kPa = {}\n",
                                   range),
                       "own.toml"),
        Contains("own.toml:5") && Contains("[lowest, highest]"));
  }
}
