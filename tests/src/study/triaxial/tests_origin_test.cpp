// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/tests_origin.hpp"

#include <catch2/catch.hpp>

#include "src/study/triaxial/test_result.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax;
using namespace triax::study;
namespace sample = triax::src::test;

TEST_CASE("origin names the simulated tests and each of their materials once") {
  std::vector<TestResult> tests(4, sample::simulated_test());
  tests[0] = sample::flow_test();
  tests[0].stored.header.specimen.material = "a sand of a laboratory";
  tests[1].stored.header.specimen.material = "inl2/x";
  tests[2].stored.header.name = "B";
  tests[2].stored.header.specimen.material = "sanisand/y";
  tests[3].stored.header.specimen.material = "inl2/x";
  const auto origin = origin_of(tests);
  CHECK(origin.tests == 4);
  CHECK(origin.simulated == std::vector<std::string>{"sim-26", "B", "sim-26"});
  CHECK(origin.materials == std::vector<std::string>{"inl2/x", "sanisand/y"});
  CHECK_FALSE(origin.all_simulated());
  tests.erase(tests.begin());
  CHECK(origin_of(tests).all_simulated());
}

TEST_CASE("a simulated test without a material has a name only") {
  auto test = sample::simulated_test();
  test.stored.header.specimen.material.clear();
  const auto origin = origin_of({test});
  CHECK(origin.simulated.size() == 1);
  CHECK(origin.materials.empty());
}
