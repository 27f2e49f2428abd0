// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/probes/grain_probe.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/sim/grains/packings.hpp"
#include "tests/sim/grains/specimens.hpp"

using namespace triax::sim;

namespace {

GrainProbing small_probe() {
  GrainProbing how;
  how.norm_pa = 100;
  how.unbalanced = 1e-5;
  how.stress_error_pa = 0.5;
  return how;
}

double degrees_of(double angle) { return angle * std::numbers::pi / 180; }

}  // namespace

TEST_CASE("Grain probe: the increment has the direction of Fig. 13 and its norm") {
  const GrainProbe p = probe(test::calm_state(), degrees_of(60), small_probe());
  REQUIRE(p.at_rest);
  CHECK(p.stress.axial == Approx(100 * std::sin(degrees_of(60))).margin(1));
  CHECK(p.stress.radial == Approx(100 * std::cos(degrees_of(60)) / std::sqrt(2.0)).margin(1));
  CHECK(p.work.lagrangian > 0);
  CHECK(p.work.eulerian() == Approx(p.work.lagrangian).epsilon(1e-3));
  CHECK(p.work.microscopic() == Approx(p.work.lagrangian).epsilon(0.05));
  CHECK(p.work.fixed_frame == Approx(p.work.lagrangian).epsilon(0.01));
  CHECK(p.work.normalised > 0.5);
}

TEST_CASE(
    "Grain probe: after unloading opposite probes mirror each other, and a null probe hardly "
    "drifts") {
  GrainProbing nothing = small_probe();
  nothing.norm_pa = 0;
  const GrainProbe none = probe(test::unloaded_state(), 0, nothing);
  for (const double angle : {240.0, 255.0, 270.0}) {
    const GrainProbe there = probe(test::unloaded_state(), degrees_of(angle), small_probe());
    const GrainProbe back = probe(test::unloaded_state(), degrees_of(angle - 180), small_probe());
    const double size = std::hypot(there.strain.axial, std::sqrt(2.0) * there.strain.radial);
    const double differs = std::hypot(there.strain.axial + back.strain.axial,
                                      std::sqrt(2.0) * (there.strain.radial + back.strain.radial));
    CHECK(differs < 0.05 * size);
    CHECK(std::hypot(none.strain.axial, none.strain.radial) < 0.05 * size);
    CHECK(std::abs(none.work.lagrangian) < 1e-2 * there.work.lagrangian);
  }
}

TEST_CASE("Grain probe: by strain the increment is put on steadily, to the last digit") {
  GrainProbing how = small_probe();
  how.kind = ProbeKind::strain;
  how.norm_strain = 2e-6;
  const GrainProbe p = probe(test::calm_state(), degrees_of(120), how);
  REQUIRE(p.at_rest);
  CHECK(p.norm_strain == 2e-6);
  CHECK(p.norm_pa == 0);
  CHECK_FALSE(p.null());
  CHECK(p.strain.axial == Approx(2e-6 * std::sin(degrees_of(120))).epsilon(1e-6));
  CHECK(p.strain.radial == Approx(2e-6 * std::cos(degrees_of(120)) / std::sqrt(2.0)).epsilon(1e-6));
  CHECK(p.work.lagrangian > 0);
  CHECK(p.work.eulerian() == Approx(p.work.lagrangian).epsilon(1e-3));
  CHECK(p.work.fixed_frame == Approx(p.work.lagrangian).epsilon(0.01));
  CHECK(p.stress_error_pa == 0);
  how.norm_strain = 0;
  CHECK(probe(test::calm_state(), 0, how).null());
}

TEST_CASE(
    "Grain probe: turning of grains and contacts is what micro- and macroscopic work differ by, "
    "dense or loose, by stress or strain; the boundary term is not") {
  const GrainState loose = test::rested(test::loose_specimen().state, 1.2e5);
  for (const GrainState* state : {&test::calm_state(), &loose})
    for (const ProbeKind kind : {ProbeKind::stress, ProbeKind::strain})
      for (const double angle : {90.0, 150.0, 210.0}) {
        GrainProbing how;
        how.kind = kind;
        how.unbalanced = 1e-5;
        const GrainProbe p = probe(*state, degrees_of(angle), how);
        INFO((state == &loose ? "loose " : "dense ") << angle << (how.kind == ProbeKind::strain));
        REQUIRE(p.at_rest);
        const GrainWork& w = p.work;
        CHECK(w.gap() > 20 * std::abs(w.gap_left()));
        CHECK(w.grains_turning > 0.5 * w.gap());
        CHECK(w.fixed_frame - w.lagrangian == Approx(w.out_of_balance).margin(0.05 * w.gap()));
        if (kind == ProbeKind::stress)
          CHECK(std::abs(w.boundary_part) > 5 * w.gap());
        else
          CHECK(std::abs(w.boundary_part) < 0.5 * w.gap());
      }
}

TEST_CASE("Grain probe: its ledger closes, and no term of it is too small to be missed") {
  for (const ProbeKind kind : {ProbeKind::stress, ProbeKind::strain}) {
    GrainProbing how;
    how.kind = kind;
    const GrainProbe p = probe(test::calm_state(), degrees_of(150), how);
    const GrainLedger& l = p.ledger;
    const double error = std::abs(l.energy_error_j());
    CHECK(l.energy_error_share() < 1e-8);
    CHECK(error < 1e-3 * p.work.lagrangian * test::calm_state().box.volume_m3());
    for (const double term :
         {l.walls_j, l.elastic_end_j - l.elastic_start_j, l.friction_j, l.damping_j})
      CHECK(std::abs(term) > 100 * error);
    double size = 0;
    for (int a = 0; a < 3; ++a) size += std::abs(l.walls_impulse[a]);
    CHECK(l.momentum_error() < 1e-9 * size);
    CHECK(size > 0);
  }
}

TEST_CASE("Grain probe: a rose does not depend on the number of threads", "[threads]") {
  GrainProbing how = small_probe();
  how.unbalanced = 1e-4;
  how.stress_error_pa = 5;
  const auto angles = rose_angles(4);
  REQUIRE(angles.size() == 4);
  CHECK(angles[1] == Approx(degrees_of(90)));
  double last = 0;
  const ProbeRose one = probe_rose(test::calm_state(), angles, how, 1),
                  two = probe_rose(test::calm_state(), angles, how, 2,
                                   [&](double done, const std::string&) {
                                     last = done;
                                     return true;
                                   });
  CHECK(last == 1);
  CHECK_FALSE(two.stopped);
  CHECK(one.null_probe.strain.axial == two.null_probe.strain.axial);
  for (std::size_t k = 0; k < angles.size(); ++k) {
    CHECK(one.probes[k].angle == angles[k]);
    CHECK(one.probes[k].strain.axial == two.probes[k].strain.axial);
    CHECK(one.probes[k].work.microscopic() == two.probes[k].work.microscopic());
    CHECK(one.probes[k].steps == two.probes[k].steps);
  }
}

TEST_CASE("Grain probe: a rose that is told to stop says so", "[threads]") {
  const ProbeRose rose = probe_rose(test::calm_state(), rose_angles(4), small_probe(), 1,
                                    [](double, const std::string&) { return false; });
  CHECK(rose.stopped);
  CHECK(rose.probes[3].stopped);
}

TEST_CASE("Grain probe: pieces of a rose are its probes to the bit, and each is in one piece") {
  GrainProbing how = small_probe();
  how.unbalanced = 1e-4;
  how.stress_error_pa = 5;
  const auto angles = rose_angles(3);
  const ProbeRose rose = probe_rose(test::calm_state(), angles, how, 2);
  std::vector<int> made(angles.size() + 1);
  for (int index = 1; index <= 3; ++index) {
    const std::vector<int> numbers = numbers_of_piece(3, index, 3);
    const SomeProbes some = some_probes(test::calm_state(), angles, numbers, how, index);
    REQUIRE(some.probes.size() == numbers.size());
    CHECK_FALSE(some.stopped);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const GrainProbe &one = some.probes[k],
                       &same = numbers[k] == 0 ? rose.null_probe : rose.probes[numbers[k] - 1];
      ++made[numbers[k]];
      CHECK(one.at_rest);
      CHECK(one.angle == same.angle);
      CHECK(one.norm_pa == same.norm_pa);
      CHECK(one.strain.axial == same.strain.axial);
      CHECK(one.work.microscopic() == same.work.microscopic());
      CHECK(one.steps == same.steps);
    }
  }
  CHECK(made == std::vector<int>(4, 1));
  CHECK(numbers_of_piece(36, 2, 4) == std::vector<int>{1, 5, 9, 13, 17, 21, 25, 29, 33});
  CHECK(numbers_of_piece(2, 4, 9).empty());
  CHECK_THROWS_AS(some_probes(test::calm_state(), angles, {4}, how, 1), std::invalid_argument);
  CHECK_THROWS_AS(some_probes(test::calm_state(), angles, {-1}, how, 1), std::invalid_argument);
}

TEST_CASE("Grain probe: settings out of their ranges are refused") {
  GrainProbing how;
  how.norm_pa = -1;
  CHECK_THROWS_AS(probe(test::calm_state(), 0, how), std::invalid_argument);
  how = {};
  how.norm_strain = -1e-6;
  CHECK_THROWS_AS(probe(test::calm_state(), 0, how), std::invalid_argument);
  how = {};
  how.ramp_steps = 1;
  CHECK_THROWS_AS(probe_rose(test::calm_state(), {}, how, 1), std::invalid_argument);
  CHECK_THROWS_AS(probe_rose(test::calm_state(), {}, {}, 0), std::invalid_argument);
}
