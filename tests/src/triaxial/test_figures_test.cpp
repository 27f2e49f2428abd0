// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/test_figures.hpp"

#include <catch2/catch.hpp>

#include "tests/src/sample_tests.hpp"

using namespace triax::src;

namespace {

std::vector<std::string> names_of(const std::vector<TestFigure>& figures) {
  std::vector<std::string> names;
  for (const auto& figure : figures) {
    REQUIRE(figure.drawing.plot);
    names.push_back(figure.name);
  }
  return names;
}

}  // namespace

TEST_CASE("a test has its path, its histories and a close view of its onset") {
  CHECK(names_of(test_figures(test::flow_test())) ==
        std::vector<std::string>{"stress_path", "history", "onset"});
}

TEST_CASE("figures without data are left out") {
  auto stable = test::stable_test();
  CHECK(names_of(test_figures(stable)) == std::vector<std::string>{"stress_path", "history"});
  stable.curves = {};
  CHECK(test_figures(stable).empty());
}
