// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/odd_tests.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::study;

namespace {

JudgedPoint on_line(double x, double y, double usual) {
  return {.y = y, .x = {x}, .x_error = {0}, .usual = usual};
}

JudgedForm mean_of(const std::vector<double>& values, double usual) {
  JudgedForm form;
  for (const double y : values)
    form.points.push_back({.y = y, .x = {}, .x_error = {}, .usual = usual});
  return form;
}

/// y = 1 − 0.5 x² and its neighbours, in the form of a line and in that of a curve.
std::vector<JudgedForm> on_curve(double off) {
  std::vector<JudgedForm> forms(2);
  forms[0].usual_slopes = {kUnknownSlope};
  forms[1].usual_slopes = {kUnknownSlope, kUnknownSlope};
  for (int i = 0; i < 10; ++i) {
    const double x = 0.2 * i, y = 1 - 0.5 * x * x + (i % 2 ? 0.01 : -0.01) + (i == 4 ? off : 0);
    forms[0].points.push_back(on_line(x, y, 0.01));
    forms[1].points.push_back({.y = y, .x = {x, x * x}, .x_error = {0, 0}, .usual = 0.01});
  }
  return forms;
}

}  // namespace

TEST_CASE("The point off the line is found, with how far off it is") {
  JudgedForm form{.points = {}, .usual_slopes = {kUnknownSlope}};
  for (int i = 0; i < 8; ++i)
    form.points.push_back(on_line(i, 0.5 * i + (i % 2 ? 0.01 : -0.01), 0.01));
  CHECK(odd_tests({form}).empty());
  form.points[5].y += 0.2;
  const auto odd = odd_tests({form});
  REQUIRE(odd.size() == 1);
  CHECK(odd[0].index == 5);
  CHECK(odd[0].residual == Approx(0.2).margin(0.03));
  form.points[5].judged = false;
  CHECK(odd_tests({form}).empty());
}

// Means by hand: the others 0, 0.01, -0.01, 0.02, -0.02 with usual 0.02 have the sum of squares
// 0.001/0.0004 = 2.5, so that f = (2.5 + 10)/(4 + 10) = 0.892857; the variance of their mean is
// 0.0004/5. A point at 0.1 is off by t = 0.1/sqrt(0.892857 (0.0004 + 0.00008)) = 4.8305.
TEST_CASE("Deviations are those worked by hand") {
  const auto odd = odd_tests({mean_of({0.0, 0.01, -0.01, 0.02, -0.02, 0.1}, 0.02)});
  REQUIRE(odd.size() == 1);
  CHECK(odd[0].index == 5);
  CHECK(odd[0].residual == Approx(0.1));
  CHECK(odd[0].deviations == Approx(4.8305).epsilon(1e-4));
}

// The same five, all at x = 0, say nothing of the slope, of which 0.05 is usual: at x = 1 the
// variance has 0.05² more, and t = 0.3/sqrt(0.892857 (0.0004 + 0.00008 + 0.0025)) = 5.8160.
TEST_CASE("Where the others do not reach, the usual slope says what may be") {
  JudgedForm form = mean_of({0.0, 0.01, -0.01, 0.02, -0.02, 0.1}, 0.02);
  form.usual_slopes = {0.05};
  for (JudgedPoint& point : form.points) point.x = {0}, point.x_error = {0};
  form.points.back().x = {1};
  CHECK(odd_tests({form}).empty());
  form.points.back().y = 0.3;
  const auto odd = odd_tests({form});
  REQUIRE(odd.size() == 1);
  CHECK(odd[0].deviations == Approx(5.8160).epsilon(1e-4));
  form.usual_slopes = {kUnknownSlope};
  CHECK(odd_tests({form}).empty());
}

TEST_CASE("The last of a row is judged where the curvature has a usual size") {
  auto forms = on_curve(0);
  JudgedForm& curve = forms[1];
  curve.usual_slopes = {kUnknownSlope, 1};
  CHECK(odd_tests({curve}).empty());
  curve.points.back().y += 0.2;
  const auto odd = odd_tests({curve});
  REQUIRE(odd.size() == 1);
  CHECK(odd[0].index == curve.points.size() - 1);
}

TEST_CASE("Three points on a line by chance condemn no fourth") {
  CHECK(odd_tests({{.points = {on_line(0, 0, 0.01), on_line(1, 1, 0.01), on_line(2, 2, 0.01),
                               on_line(3, 3.01, 0.01)},
                    .usual_slopes = {kUnknownSlope}}})
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
  std::vector<JudgedForm> forms(2);
  forms[1].usual_slopes = {kUnknownSlope, kUnknownSlope};
  for (const double x : {0.0, 1.0, 2.0, 3.0}) {
    const double y = x == 3 ? 1.0 : 0.0;
    forms[0].points.push_back({.y = y, .x = {}, .x_error = {}, .usual = 0.01});
    forms[1].points.push_back({.y = y, .x = {x, x * x}, .x_error = {0, 0}, .usual = 0.01});
  }
  CHECK(odd_tests({forms[0]}).size() == 1);
  CHECK(odd_tests(forms).empty());
}

TEST_CASE("No more than a third is taken out") {
  CHECK(odd_tests({mean_of({0, 0, 0, 30, 40, 50}, 0.01)}).size() <= 2);
}
