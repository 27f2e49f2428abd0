// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/odd_tests.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::study;

namespace {

JudgedPoint on_line(double x, double y, double usual) {
  return {.y = y, .x = {x}, .x_error = {0}, .usual = usual};
}

/// y = 1 − 0.5 x² and its neighbours, in the form of a line and in that of a curve.
std::vector<std::vector<JudgedPoint>> on_curve(double off) {
  std::vector<std::vector<JudgedPoint>> forms(2);
  for (int i = 0; i < 10; ++i) {
    const double x = 0.2 * i, y = 1 - 0.5 * x * x + (i % 2 ? 0.01 : -0.01) + (i == 4 ? off : 0);
    forms[0].push_back(on_line(x, y, 0.01));
    forms[1].push_back({.y = y, .x = {x, x * x}, .x_error = {0, 0}, .usual = 0.01});
  }
  return forms;
}

}  // namespace

TEST_CASE("The point off the line is found, with how far off it is") {
  std::vector<JudgedPoint> points;
  for (int i = 0; i < 8; ++i) points.push_back(on_line(i, 0.5 * i + (i % 2 ? 0.01 : -0.01), 0.01));
  CHECK(odd_tests({points}).empty());
  points[5].y += 0.2;
  const auto odd = odd_tests({points});
  REQUIRE(odd.size() == 1);
  CHECK(odd[0].index == 5);
  CHECK(odd[0].residual == Approx(0.2).margin(0.03));
  points[5].judged = false;
  CHECK(odd_tests({points}).empty());
}

// Means by hand: the others 0, 0.01, -0.01, 0.02, -0.02 with usual 0.02 have the sum of squares
// 0.001/0.0004 = 2.5, so that f = (2.5 + 10)/(4 + 10) = 0.892857; the variance of their mean is
// 0.0004/5. A point at 0.1 is off by t = 0.1/sqrt(0.892857 (0.0004 + 0.00008)) = 4.8305.
TEST_CASE("Deviations are those worked by hand") {
  std::vector<JudgedPoint> points;
  for (const double y : {0.0, 0.01, -0.01, 0.02, -0.02, 0.1})
    points.push_back({.y = y, .x = {}, .x_error = {}, .usual = 0.02});
  const auto odd = odd_tests({points});
  REQUIRE(odd.size() == 1);
  CHECK(odd[0].index == 5);
  CHECK(odd[0].residual == Approx(0.1));
  CHECK(odd[0].deviations == Approx(4.8305).epsilon(1e-4));
}

TEST_CASE("Three points on a line by chance condemn no fourth") {
  CHECK(odd_tests({{on_line(0, 0, 0.01), on_line(1, 1, 0.01), on_line(2, 2, 0.01),
                    on_line(3, 3.01, 0.01)}})
            .empty());
}

TEST_CASE("On a curve the test off the curve is odd, and not the ends of the line through it") {
  CHECK(odd_tests(on_curve(0)).empty());
  const auto odd = odd_tests(on_curve(0.15));
  REQUIRE(odd.size() == 1);
  CHECK(odd[0].index == 4);
  CHECK(odd[0].residual == Approx(0.15).margin(0.03));
}

TEST_CASE("A form for which the others are too few judges nobody") {
  std::vector<std::vector<JudgedPoint>> forms(2);
  for (const double x : {0.0, 1.0, 2.0, 3.0}) {
    const double y = x == 3 ? 1.0 : 0.0;
    forms[0].push_back({.y = y, .x = {}, .x_error = {}, .usual = 0.01});
    forms[1].push_back({.y = y, .x = {x, x * x}, .x_error = {0, 0}, .usual = 0.01});
  }
  CHECK(odd_tests({forms[0]}).size() == 1);
  CHECK(odd_tests(forms).empty());
}

TEST_CASE("No more than a third is taken out") {
  std::vector<JudgedPoint> points;
  for (int i = 0; i < 6; ++i)
    points.push_back({.y = i < 3 ? 0.0 : 10.0 * i, .x = {}, .x_error = {}, .usual = 0.01});
  CHECK(odd_tests({points}).size() <= 2);
}
