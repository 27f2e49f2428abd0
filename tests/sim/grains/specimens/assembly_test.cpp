// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/specimens/assembly.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>

#include "sim/grains/state/grain_measures.hpp"
#include "tests/sim/grains/packings.hpp"
#include "tests/sim/grains/specimens.hpp"

using namespace triax::sim;

TEST_CASE("Compaction: a specimen is calm, at its pressure, with its own friction") {
  const Compacted& specimen = test::dense_specimen();
  REQUIRE(specimen.calm);
  const GrainMeasures m = measure(specimen.state);
  for (const double stress : m.wall_stress_pa) CHECK(stress == Approx(1e5).epsilon(0.01));
  CHECK(m.unbalanced < 1e-3);
  CHECK(m.grains_outside == 0);
  CHECK(m.porosity == specimen.porosity);
  CHECK(m.coordination > 3.5);
  CHECK(specimen.state.law == ContactLaw{});
}

TEST_CASE("Compaction: less friction makes a denser specimen") {
  REQUIRE(test::loose_specimen().calm);
  CHECK(test::dense_specimen().porosity < test::loose_specimen().porosity - 0.01);
  CHECK(measure(test::dense_specimen().state).coordination >
        measure(test::loose_specimen().state).coordination);
}

TEST_CASE("Compaction: the same cloud gives the same bits") {
  const Cloud cloud = test::small_cloud(60);
  CHECK(test::same_bits(compact(cloud, {}, {}).state, compact(cloud, {}, {}, 2).state));
}

TEST_CASE("Compaction: progress never falls, and stops the work") {
  double last = 0;
  int calls = 0;
  const Compacted stopped =
      compact(test::small_cloud(60), {}, {}, 1, [&](double done, const std::string& what) {
        CHECK(done >= last);
        CHECK_FALSE(what.empty());
        last = done;
        return ++calls < 5;
      });
  CHECK(calls == 5);
  CHECK(stopped.stopped);
  CHECK_FALSE(stopped.calm);
}

TEST_CASE("Compaction: settings out of their ranges are refused") {
  Compaction how;
  how.pressure_pa = 0;
  CHECK_THROWS_AS(compact(test::small_cloud(10), {}, how), std::invalid_argument);
  how = {};
  how.friction_angle = -1;
  CHECK_THROWS_AS(compact(test::small_cloud(10), {}, how), std::invalid_argument);
}
