// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/specimens/grading.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <stdexcept>

using namespace triax::sim;

TEST_CASE("Grading: the curve is read both ways") {
  const GradingCurve curve = paper_grading();
  CHECK(diameter_at(curve, 0) == 2e-3);
  CHECK(diameter_at(curve, 0.01) == Approx(2e-3));
  CHECK(diameter_at(curve, 0.5) == Approx(5e-3));
  CHECK(diameter_at(curve, 0.05) == Approx(2.5e-3));
  CHECK(diameter_at(curve, 1) == 9.5e-3);
  CHECK(share_at(curve, 1.9e-3) == 0);
  CHECK(share_at(curve, 2e-3) == Approx(0.01));
  CHECK(share_at(curve, 8.75e-3) == Approx(0.975));
  CHECK(share_at(curve, 0.1) == 1);
}

TEST_CASE("Grading: drawn diameters meet the curve everywhere within one grain") {
  const GradingCurve curve = paper_grading();
  for (const int count : {7, 100, 5000}) {
    std::vector<double> d = draw_diameters(curve, count, 3);
    REQUIRE(d.size() == static_cast<std::size_t>(count));
    std::sort(d.begin(), d.end());
    for (int k = 0; k < count; ++k) {
      const double share = share_at(curve, d[k]);
      if (d[k] > 2e-3) CHECK(share * count >= k - 1e-6);
      CHECK(diameter_at(curve, static_cast<double>(k) / count) <= d[k] * (1 + 1e-12));
      CHECK(diameter_at(curve, (k + 1.0) / count) >= d[k] * (1 - 1e-12));
    }
  }
}

TEST_CASE("Grading: the seed decides diameters and their order") {
  const GradingCurve curve = paper_grading();
  const auto one = draw_diameters(curve, 200, 1);
  CHECK(one == draw_diameters(curve, 200, 1));
  CHECK(one != draw_diameters(curve, 200, 2));
  CHECK_FALSE(std::is_sorted(one.begin(), one.end()));
}

TEST_CASE("Grading: one size is a curve of one point") {
  for (const double d : draw_diameters({{3e-3}, {1}}, 5, 1)) CHECK(d == 3e-3);
}

TEST_CASE("Grading: what is no curve is refused") {
  CHECK_THROWS_AS(check(GradingCurve{}), std::invalid_argument);
  CHECK_THROWS_AS(check(GradingCurve{{1e-3, 2e-3}, {1}}), std::invalid_argument);
  CHECK_THROWS_AS(check(GradingCurve{{2e-3, 1e-3}, {0, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(check(GradingCurve{{0, 1e-3}, {0, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(check(GradingCurve{{1e-3, 2e-3}, {0.5, 0.9}}), std::invalid_argument);
  CHECK_THROWS_AS(check(GradingCurve{{1e-3, 2e-3, 3e-3}, {0.5, 0.4, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(draw_diameters(paper_grading(), 0, 1), std::invalid_argument);
}
