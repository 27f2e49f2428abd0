// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/specimens/cloud.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "sim/grains/specimens/grading.hpp"

using namespace triax::sim;

TEST_CASE("Cloud: spheres neither overlap nor leave the box, and fill the share asked for") {
  const auto diameters = draw_diameters(paper_grading(), 800, 4);
  const Cloud cloud = make_cloud(diameters, 5);
  REQUIRE(cloud.spheres.size() == diameters.size());
  double solid = 0;
  for (std::size_t i = 0; i < diameters.size(); ++i) {
    const Sphere& a = cloud.spheres[i];
    REQUIRE(a.radius_m == 0.5 * diameters[i]);
    solid += std::numbers::pi / 6 * std::pow(diameters[i], 3);
    for (int x = 0; x < 3; ++x) {
      REQUIRE(a.centre_m[x] >= cloud.box.low_m[x] + a.radius_m);
      REQUIRE(a.centre_m[x] <= cloud.box.high_m[x] - a.radius_m);
    }
    for (std::size_t j = 0; j < i; ++j) {
      const Sphere& b = cloud.spheres[j];
      const double distance =
          std::hypot(a.centre_m[0] - b.centre_m[0], a.centre_m[1] - b.centre_m[1],
                     a.centre_m[2] - b.centre_m[2]);
      REQUIRE(distance >= (a.radius_m + b.radius_m) * (1 - 1e-12));
    }
  }
  CHECK(solid / cloud.box.volume_m3() == Approx(0.4));
  CHECK(cloud.box.length_m(0) == cloud.box.length_m(2));
}

TEST_CASE("Cloud: the seed decides where spheres are") {
  const std::vector<double> diameters(50, 2e-3);
  const Cloud one = make_cloud(diameters, 1, 0.2), same = make_cloud(diameters, 1, 0.2),
              other = make_cloud(diameters, 2, 0.2);
  CHECK(one.spheres[7].centre_m == same.spheres[7].centre_m);
  CHECK(one.spheres[7].centre_m != other.spheres[7].centre_m);
}

TEST_CASE("Cloud: what cannot be placed is refused") {
  CHECK_THROWS_AS(make_cloud({}, 1), std::invalid_argument);
  CHECK_THROWS_AS(make_cloud({1e-3, 0}, 1), std::invalid_argument);
  CHECK_THROWS_AS(make_cloud({1e-3, 1e-3}, 1, 0.9), std::invalid_argument);
  CHECK_THROWS_AS(make_cloud({1e-2, 1e-2}, 1, 0.45), std::invalid_argument);
}
