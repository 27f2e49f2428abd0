// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/specimens/porosity_search.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "tests/sim/grains/specimens.hpp"

using namespace triax::sim;

TEST_CASE("Porosity search: a porosity between two others is found with a friction between") {
  const Cloud cloud = test::small_cloud(150);
  const auto porosity_with = [&](double friction) {
    Compaction how;
    how.friction_angle = friction;
    return compact(cloud, {}, how).porosity;
  };
  PorositySearch search;
  search.lowest_friction = 0.05;
  search.highest_friction = 0.6;
  const double low = porosity_with(0.05), high = porosity_with(0.6);
  REQUIRE(low < high);
  search.porosity = 0.5 * (low + high);
  search.tolerance = 0.003;
  const PorosityFound found = seek_porosity(cloud, {}, {}, search);
  REQUIRE(found.reached);
  CHECK(std::abs(found.best.porosity - search.porosity) <= 0.003);
  CHECK(found.friction_angle > 0.05);
  CHECK(found.friction_angle < 0.6);
  CHECK(porosity_with(found.friction_angle) == found.best.porosity);
}

TEST_CASE("Porosity search: what lies beyond the bracket is said") {
  PorositySearch search;
  search.porosity = 0.2;
  const PorosityFound dense = seek_porosity(test::small_cloud(60), {}, {}, search);
  CHECK_FALSE(dense.reached);
  CHECK(dense.below_bracket);
  CHECK(dense.friction_angle == Approx(search.lowest_friction));
  search.porosity = 0.7;
  const PorosityFound loose = seek_porosity(test::small_cloud(60), {}, {}, search);
  CHECK(loose.above_bracket);
  CHECK(loose.friction_angle == Approx(search.highest_friction));
  search.lowest_friction = 2;
  CHECK_THROWS_AS(seek_porosity(test::small_cloud(60), {}, {}, search), std::invalid_argument);
}
