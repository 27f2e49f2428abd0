// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/grain_ledger.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/grains/engine/grains.hpp"
#include "sim/grains/state/grain_measures.hpp"
#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;

namespace {

/// Compressed along one axis between servos, with all that takes energy; sorts on its way.
Grains booked(int side, int threads, double time_step) {
  GrainState state = test::lattice(side);
  test::shake(state, 0.05);
  Grains grains(state, threads);
  grains.set_time_step(time_step);
  grains.drive({stress_drive(5e4), strain_rate_drive(2), stress_drive(5e4)});
  grains.keep_ledger();
  return grains;
}

GrainLedger after(Grains grains, std::int64_t steps) {
  REQUIRE(grains.step(steps) == steps);
  return grains.ledger().value();
}

}  // namespace

TEST_CASE(
    "Grains: sliding takes the force at Coulomb's limit times the way beyond the elastic one") {
  const double r = 1e-3, overlap = 1e-6, friction = 0.3, speed = 0.03, step = 1e-7;
  ContactLaw law = test::undamped(friction);
  law.density_kg_per_m3 = 1e15;  // nothing moves but as its velocity says
  GrainState state = test::pair_of(r, r, overlap, law, step);
  test::grain(state, 1).velocity[1] = speed;
  Grains grains(state);
  grains.keep_ledger();
  CHECK_FALSE(grains.ledger());
  grains.step(1001);
  const double normal = normal_stiffness(law, r, r) * overlap;
  const double limit = std::tan(friction) * normal;
  const double elastic_way = limit / (law.tangential_ratio * normal_stiffness(law, r, r));
  const GrainLedger ledger = grains.ledger().value();
  const double way = 1001 * speed * step;
  REQUIRE(way > 3 * elastic_way);
  CHECK(ledger.friction_j == Approx(limit * (way - elastic_way)).epsilon(2e-3));
  CHECK(ledger.damping_j == 0);
  CHECK(ledger.walls_j == 0);
}

TEST_CASE("Grains: a free sphere between walls takes and gives back what the ledger says") {
  // Against a wall with k: half a period later its energy is back; at the deepest it was elastic.
  const ContactLaw law = test::undamped();
  GrainState state =
      make_grain_state({{{1e-3, 5e-3, 5e-3}, 1e-3}}, {{0, 0, 0}, {1e-2, 1e-2, 1e-2}}, law, 1e-8);
  state.grains[0].velocity[0] = -0.01;
  const double mass = test::mass(state.grains[0]);
  const double quarter = 0.5 * 3.14159265358979 * std::sqrt(mass / wall_stiffness(law, 1e-3));
  Grains grains(state);
  grains.keep_ledger();
  grains.step(std::lround(quarter / 1e-8));
  const GrainLedger deepest = grains.ledger().value();
  CHECK(deepest.elastic_end_j == Approx(0.5 * mass * 1e-4).epsilon(1e-4));
  CHECK(deepest.kinetic_end_j < 1e-5 * deepest.elastic_end_j);
  CHECK(deepest.walls_impulse[0] == Approx(mass * 0.01).epsilon(5e-3));
  grains.step(2 * std::lround(quarter / 1e-8));
  const GrainLedger back = grains.ledger().value();
  CHECK(back.elastic_end_j == 0);
  CHECK(back.kinetic_end_j == Approx(0.5 * mass * 1e-4).epsilon(1e-6));
  CHECK(back.walls_impulse[0] == Approx(2 * mass * 0.01).epsilon(1e-3));
  CHECK(back.energy_error_share() < 1e-6);
}

TEST_CASE("Grains: the ledger of a specimen in motion closes, the better the shorter the step") {
  const GrainLedger coarse = after(booked(8, 1, 1e-6), 2000),
                    fine = after(booked(8, 1, 1e-7), 20000);
  for (const GrainLedger& ledger : {coarse, fine}) {
    CHECK(ledger.walls_j < 0);  // so dense that it pushes them out
    CHECK(ledger.friction_j > 0);
    CHECK(ledger.damping_j > 0);
    CHECK(ledger.elastic_end_j > 0);
    double size = 0;
    for (int a = 0; a < 3; ++a)
      size += std::abs(ledger.walls_impulse[a]) + std::abs(ledger.damping_impulse[a]);
    REQUIRE(size > 0);
    CHECK(ledger.momentum_error() < 1e-9 * size);
  }
  INFO(coarse.energy_error_share() << " and " << fine.energy_error_share());
  CHECK(coarse.energy_error_share() < 2e-3);
  CHECK(fine.energy_error_share() < 2e-4);
}

TEST_CASE("Grains: motion that is taken out, or given, is in the ledger") {
  Grains grains = booked(6, 1, 1e-7);
  grains.step(300);
  const double kinetic = kinetic_energy(grains.state());
  const GrainLedger before = grains.ledger().value();
  grains.stop_motion();
  CHECK(grains.ledger()->stopped_j == Approx(kinetic));
  CHECK(grains.ledger()->energy_error_j() ==
        Approx(before.energy_error_j()).margin(1e-6 * kinetic));
  grains.set_velocity(2, {0.1, 0, 0});
  const double given = 0.5 * 0.01 * test::mass(grains.state().grains[2]);
  CHECK(grains.ledger()->stopped_j == Approx(kinetic - given));
  grains.step(3000);
  CHECK(grains.ledger()->energy_error_share() < 2e-3);
  double size = 0;
  for (int a = 0; a < 3; ++a) size += std::abs(grains.ledger()->stopped_impulse[a]);
  CHECK(grains.ledger()->momentum_error() < 1e-9 * size);
}

TEST_CASE("Grains: with a ledger the bits are the same, and so is it on any threads", "[threads]") {
  Grains one = booked(17, 1, 1e-6), two = booked(17, 2, 1e-6);
  Grains without(one.state());
  for (Grains* g : {&one, &two, &without}) REQUIRE(g->step(200) == 200);
  CHECK(test::same_bits(one.state(), without.state()));
  CHECK(one.ledger()->friction_j == two.ledger()->friction_j);
  CHECK(one.ledger()->damping_j == two.ledger()->damping_j);
  CHECK(one.ledger()->walls_j == two.ledger()->walls_j);
  CHECK_FALSE(without.ledger());
  one.restore(two.state());
  CHECK_FALSE(one.ledger());
}

TEST_CASE("Grains: a ledger has the same bits with every instruction set") {
  const auto ledger = [](InstructionSet set) {
    Grains grains(booked(17, 1, 1e-6).state(), 1, set);
    grains.keep_ledger();
    grains.step(300);
    return grains.ledger().value();
  };
  const GrainLedger portable = ledger(InstructionSet::portable);
  REQUIRE(portable.friction_j > 0);
  REQUIRE(portable.damping_j > 0);
  for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
    if (!available(set)) continue;
    const GrainLedger other = ledger(set);
    CHECK(other.friction_j == portable.friction_j);
    CHECK(other.damping_j == portable.damping_j);
    CHECK(other.kinetic_end_j == portable.kinetic_end_j);
    CHECK(other.momentum_end == portable.momentum_end);
    CHECK(other.damping_impulse == portable.damping_impulse);
  }
}
