// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/walls.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "sim/grains/state/grain_measures.hpp"
#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;

namespace {

Grains driven(const std::array<AxisDrive, 3>& drives, std::int64_t steps) {
  Grains grains(test::lattice(6));
  grains.drive(drives);
  grains.step(steps);
  return grains;
}

}  // namespace

TEST_CASE("Grains: a strain rate shortens the box exponentially about its middle") {
  const GrainBox start = test::lattice(6).box;
  const Grains grains = driven({strain_rate_drive(3), strain_rate_drive(-1), {}}, 2000);
  const GrainState& s = grains.state();
  CHECK(std::log(start.length_m(0) / s.box.length_m(0)) == Approx(3 * 2e-3).epsilon(1e-5));
  CHECK(std::log(start.length_m(1) / s.box.length_m(1)) == Approx(-1 * 2e-3).epsilon(1e-5));
  CHECK(s.box.length_m(2) == start.length_m(2));
  CHECK(s.box.low_m[0] + s.box.high_m[0] == Approx(start.low_m[0] + start.high_m[0]));
  CHECK(s.time_s == Approx(2e-3));
  CHECK(s.steps == 2000);
}

TEST_CASE("Grains: servos bring all three axes to their stresses") {
  const Grains grains = driven({stress_drive(3e5), stress_drive(4e5), stress_drive(3.5e5)}, 40000);
  const GrainMeasures m = measure(grains.state());
  CHECK(m.wall_stress_pa[0] == Approx(3e5).epsilon(2e-3));
  CHECK(m.wall_stress_pa[1] == Approx(4e5).epsilon(2e-3));
  CHECK(m.wall_stress_pa[2] == Approx(3.5e5).epsilon(2e-3));
  CHECK(m.unbalanced < 1e-2);
  CHECK(m.grains_outside == 0);
  for (int a = 0; a < 3; ++a)
    CHECK(wall_stress(grains.state().walls, grains.state().box, a) ==
          Approx(m.wall_stress_pa[a]).epsilon(1e-4));
}

TEST_CASE("Grains: a target runs to its goal at its rate") {
  Grains grains = driven({stress_drive(3e5), stress_drive(3e5), stress_drive(3e5)}, 40000);
  AxisDrive ramp = stress_drive(3.2e5);
  ramp.stress_rate_pa_per_s = 1e6;
  grains.drive({stress_drive(3e5), ramp, stress_drive(3e5)});
  const double start = grains.state().walls.stress_target_pa[1];
  CHECK(start == Approx(3e5).epsilon(2e-3));
  grains.step(10000);
  CHECK(grains.state().walls.stress_target_pa[1] == Approx(start + 1e4));
  grains.step(20000);
  CHECK(grains.state().walls.stress_target_pa[1] == 3.2e5);
  CHECK(measure(grains.state()).wall_stress_pa[1] == Approx(3.2e5).epsilon(2e-3));
}

TEST_CASE("Grains: followers with ratio -1/2 keep the volume, and the leader holds q") {
  Grains grains = driven({stress_drive(3e5), stress_drive(3e5), stress_drive(3e5)}, 40000);
  const double volume = grains.state().box.volume_m3();
  grains.drive({following_drive(1, -0.5), stress_drive(2e4), following_drive(1, -0.5)});
  CHECK(std::abs(grains.state().walls.stress_target_pa[1]) < 2e3);
  grains.step(40000);
  const auto stress = measure(grains.state()).wall_stress_pa;
  CHECK(stress[1] - 0.5 * (stress[0] + stress[2]) == Approx(2e4).epsilon(0.02));
  CHECK(conjugate_stress(grains.state().walls, grains.state().box, 1) == Approx(2e4).epsilon(0.02));
  CHECK(grains.state().box.volume_m3() == Approx(volume).epsilon(1e-6));
  CHECK(grains.state().box.length_m(1) < 0.99999 * grains.state().box.length_m(0));
}

TEST_CASE("Grains: a servo holds its stress while another axis is strained steadily") {
  Grains grains = driven({stress_drive(3e5), stress_drive(3e5), stress_drive(3e5)}, 40000);
  grains.drive({stress_drive(3e5), strain_rate_drive(0.5), stress_drive(3e5)});
  grains.step(6000);
  double sum = 0;
  for (int k = 0; k < 100; ++k) {
    grains.step(10);
    sum += wall_stress(grains.state().walls, grains.state().box, 0);
  }
  CHECK(sum / 100 == Approx(3e5).epsilon(2e-3));
  CHECK(grains.state().walls.learned_rate_per_s[0] < -0.01);
  grains.drive({stress_drive(3e5), stress_drive(3e5), stress_drive(3e5)});
  CHECK(grains.state().walls.learned_rate_per_s[0] == 0);
}

TEST_CASE("Grains: the speed limit of a servo is one") {
  Grains grains(test::lattice(4, {}, 4e-3));
  grains.drive({stress_drive(1e6, 0.02), {}, {}});
  for (int s = 0; s < 500; ++s) {
    grains.step(1);
    REQUIRE(wall_speed(grains.state()) <= 0.02 * (1 + 1e-9));
  }
  CHECK(wall_speed(grains.state()) == Approx(0.02).epsilon(1e-3));
}

TEST_CASE("Grains: drives that make no sense are refused and change nothing") {
  Grains grains(test::lattice(3));
  const auto before = grains.state().walls.drive;
  AxisDrive bad = stress_drive(1e5, 0);
  CHECK_THROWS_AS(grains.drive({bad, {}, {}}), std::invalid_argument);
  CHECK_THROWS_AS(grains.drive({following_drive(0, 1), {}, {}}), std::invalid_argument);
  CHECK_THROWS_AS(grains.drive({following_drive(3, 1), {}, {}}), std::invalid_argument);
  CHECK_THROWS_AS(grains.drive({strain_rate_drive(NAN), {}, {}}), std::invalid_argument);
  bad = stress_drive(1e5);
  bad.stress_rate_pa_per_s = -1;
  CHECK_THROWS_AS(grains.drive({bad, {}, {}}), std::invalid_argument);
  CHECK(grains.state().walls.drive == before);
}
