// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/odd_tests.hpp"

#include <catch2/catch.hpp>

using namespace triax::study;

TEST_CASE("The point off the line is found, with how far off it is") {
  std::vector<FitPoint> points;
  for (int i = 0; i < 8; ++i)
    points.push_back({1.0 * i, 0.5 * i + (i % 2 ? 0.01 : -0.01), 0, 0.01});
  CHECK(odd_tests(points, FitKind::line, 0.01).empty());
  points[5].y += 0.2;
  const auto odd = odd_tests(points, FitKind::line, 0.01);
  REQUIRE(odd.size() == 1);
  CHECK(odd[0].index == 5);
  CHECK(odd[0].residual == Approx(0.2).margin(0.03));
}

TEST_CASE("Three points on a line by chance condemn no fourth") {
  const std::vector<FitPoint> points = {{0, 0}, {1, 1}, {2, 2}, {3, 3.01}};
  CHECK(odd_tests(points, FitKind::line, 0.01).empty());
}

TEST_CASE("No more than a third is taken out") {
  std::vector<FitPoint> points;
  for (int i = 0; i < 6; ++i) points.push_back({0, i < 3 ? 0.0 : 10.0 * i, 0, 0.01});
  CHECK(odd_tests(points, FitKind::mean, 0.01).size() <= 2);
}
