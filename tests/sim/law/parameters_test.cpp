// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/law/parameters.hpp"

#include <catch2/catch.hpp>

#include "sim/materials/laws.hpp"

using namespace triax::sim;
using Catch::Contains;

namespace {

struct Two {
  double modulus_pa = 0, ratio = 0;
};
const ParameterTable<Two> kTable = {
    {{"modulus_kPa", "E", "kPa", "stiffness", {.above = 0}}, &Two::modulus_pa},
    {{.key = "ratio", .symbol = "ν", .meaning = "a ratio", .range = {.below = 0.5}, .usual = 0.2},
     &Two::ratio}};

}  // namespace

TEST_CASE("parameters arrive in SI, the usual value where none is given") {
  ParameterSet set;
  set.numbers["modulus_kPa"] = 3;
  const Two p = parameters_from(set, kTable);
  CHECK(p.modulus_pa == 3000);
  CHECK(p.ratio == 0.2);
}

TEST_CASE("what is missing or out of range is said with its name and range") {
  CHECK_THROWS_WITH(parameters_from(ParameterSet{}, kTable), Contains("modulus_kPa is missing"));
  ParameterSet set;
  set.numbers = {{"modulus_kPa", -1}, {"ratio", 0.1}};
  CHECK_THROWS_WITH(parameters_from(set, kTable), Contains("modulus_kPa is -1, must be above 0"));
  set.numbers = {{"modulus_kPa", 1}, {"ratio", 0.5}};
  CHECK_THROWS_WITH(parameters_from(set, kTable), Contains("ratio is 0.5, must be below 0.5"));
  CHECK_THROWS_WITH(check_parameters(Two{1, std::nan("")}, kTable), Contains("ratio is nan"));
}

TEST_CASE("the ten laws are known by the names of files and command line, each says its source") {
  const std::vector<std::string> wanted = {
      "elastic",  "mohr_coulomb", "drucker_prager", "cam_clay",   "hypoplastic",
      "sanisand", "norsand",      "inl2",           "octolinear", "umat"};
  CHECK(laws().size() == wanted.size());
  for (const auto& name : wanted) {
    INFO(name);
    const auto* law = find_law(name);
    REQUIRE(law != nullptr);
    CHECK_FALSE(law->title.empty());
    CHECK_FALSE(law->source.empty());
    CHECK_FALSE(law->parameters.empty());
  }
  CHECK(find_law("camclay") == nullptr);
  CHECK_FALSE(find_law("norsand")->refuses.empty());
}
