// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/grains.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "sim/grains/engine/grain_ledger.hpp"
#include "sim/grains/state/grain_measures.hpp"
#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;
using Eigen::Vector3d;
using triax::sim::test::same_bits;

namespace {

Vector3d vector(const double* v) { return {v[0], v[1], v[2]}; }

/// A handful of grains in the middle of nowhere.
GrainState cluster(const ContactLaw& law, double speed) {
  const GrainState packing = test::lattice(4, law);
  GrainState state =
      make_grain_state(spheres_of(packing), test::far_walls(), law, packing.time_step_s);
  test::shake(state, speed);
  return state;
}

struct Momentum {
  Vector3d linear = Vector3d::Zero(), angular = Vector3d::Zero();
  double size = 0, angular_size = 0;
};

Momentum momentum(const GrainState& state) {
  Momentum p;
  for (const Grain& g : state.grains) {
    const Vector3d v = vector(g.velocity) / g.inverse_mass;
    const Vector3d l = vector(g.position).cross(v) + vector(g.spin) / g.inverse_inertia;
    p.linear += v;
    p.angular += l;
    p.size += v.norm();
    p.angular_size += l.norm();
  }
  return p;
}

std::array<AxisDrive, 3> shearing() {
  return {stress_drive(5e4), strain_rate_drive(2), stress_drive(5e4)};
}

/// A specimen in motion, with sorts and renewals within some hundred steps.
Grains sheared(int side, int threads, InstructionSet set = best_instruction_set()) {
  GrainState state = test::lattice(side);
  test::shake(state, 0.2);
  state.margin = {1e-4, 2e-5};
  Grains grains(state, threads, set);
  grains.set_margin(state.margin);
  grains.drive(shearing());
  return grains;
}

/// Largest difference of a position between two states of one specimen, m.
double largest_difference(const GrainState& a, const GrainState& b) {
  const auto sa = spheres_of(a), sb = spheres_of(b);
  double largest = 0;
  for (std::size_t i = 0; i < sa.size(); ++i)
    for (int x = 0; x < 3; ++x)
      largest = std::max(largest, std::abs(sa[i].centre_m[x] - sb[i].centre_m[x]));
  return largest;
}

}  // namespace

TEST_CASE("Grains: a free cluster keeps its momentum to round-off") {
  GrainState state = cluster(test::undamped(), 0.5);
  const Momentum before = momentum(state);
  Grains grains(state);
  REQUIRE(grains.step(2000) == 2000);
  const Momentum after = momentum(grains.state());
  REQUIRE(largest_difference(state, grains.state()) > 1e-4);
  CHECK((after.linear - before.linear).norm() < 1e-12 * before.size);
  CHECK((after.angular - before.angular).norm() < 1e-11 * before.angular_size);
}

TEST_CASE("Grains: without friction and damping a packing keeps its energy") {
  GrainState state = test::lattice(5, test::undamped(0));
  test::shake(state, 0.1);
  Grains grains(state);
  grains.set_time_step(1e-7);
  grains.step(1);
  const double before = kinetic_energy(grains.state()) + elastic_energy(grains.state());
  const double kinetic_before = kinetic_energy(grains.state());
  grains.step(3000);
  const double after = kinetic_energy(grains.state()) + elastic_energy(grains.state());
  CHECK(after == Approx(before).epsilon(2e-3));
  CHECK(std::abs(kinetic_energy(grains.state()) / kinetic_before - 1) > 0.02);
}

TEST_CASE("Grains: friction and damping take energy away") {
  GrainState state = test::lattice(5);
  test::shake(state, 0.1);
  Grains grains(state);
  grains.step(1);
  const double before = kinetic_energy(grains.state()) + elastic_energy(grains.state());
  grains.step(20000);
  CHECK(kinetic_energy(grains.state()) < 1e-3 * before);
}

TEST_CASE("Grains: a cluster that is moved and turned as a whole goes on the same way") {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Vector3d shift(0.11, -0.07, 0.05);
  GrainState state = cluster(test::undamped(), 0.1);
  std::vector<Sphere> turned = spheres_of(state);
  for (Sphere& s : turned)
    Eigen::Map<Vector3d>(s.centre_m.data()) = (turn * vector(s.centre_m.data()) + shift).eval();
  GrainState other = make_grain_state(turned, test::far_walls(), state.law, state.time_step_s);
  for (std::size_t i = 0; i < turned.size(); ++i) {
    const int id = static_cast<int>(i);
    const Grain& from = test::grain(state, id);
    Grain& to = test::grain(other, id);
    Eigen::Map<Vector3d>(to.velocity) = turn * vector(from.velocity);
    Eigen::Map<Vector3d>(to.spin) = turn * vector(from.spin);
  }
  Grains a(state), b(other);
  a.step(200);
  b.step(200);
  double largest = 0, speed = 0;
  for (std::size_t i = 0; i < turned.size(); ++i) {
    const int id = static_cast<int>(i);
    const Vector3d va = vector(test::grain(a.state(), id).velocity),
                   vb = vector(test::grain(b.state(), id).velocity);
    largest = std::max(largest, (turn * va - vb).norm());
    speed = std::max(speed, va.norm());
  }
  CHECK(speed > 0.1);
  CHECK(largest < 1e-8 * speed);
}

TEST_CASE("Grains: one, two and three threads give the same bits", "[threads]") {
  Grains one = sheared(17, 1), two = sheared(17, 2), three = sheared(17, 3);
  const std::int64_t sorts = one.state().sorts;
  for (Grains* g : {&one, &two, &three}) REQUIRE(g->step(400) == 400);
  REQUIRE(one.state().sorts > sorts + 1);
  CHECK(same_bits(one.state(), two.state()));
  CHECK(same_bits(one.state(), three.state()));
}

TEST_CASE("Grains: every instruction set gives the same bits") {
  Grains portable = sheared(9, 1, InstructionSet::portable);
  portable.step(600);
  REQUIRE(measure(portable.state()).sliding_contacts > 10);
  for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
    if (!available(set)) {
      WARN("this processor has not every instruction set: skipped");
      continue;
    }
    Grains vectors = sheared(9, 1, set);
    vectors.step(600);
    CHECK(same_bits(portable.state(), vectors.state()));
  }
}

TEST_CASE("Grains: how many steps are asked for at once does not matter") {
  Grains at_once = sheared(6, 1), one_by_one = sheared(6, 1);
  at_once.step(150);
  for (int s = 0; s < 150; ++s) one_by_one.step(1);
  CHECK(same_bits(at_once.state(), one_by_one.state()));
}

TEST_CASE("Grains: a state that was saved and restored goes on with the same bits") {
  Grains grains = sheared(8, 1);
  grains.step(20);
  const std::int64_t sorts = grains.state().sorts;
  GrainState before;
  while (grains.state().sorts == sorts) {
    before = grains.state();
    grains.step(1);
    REQUIRE(grains.state().steps < 5000);
  }
  const GrainState after = grains.state();
  grains.step(99);
  Grains from_before(load_grains(save_grains(before)));
  from_before.step(100);
  CHECK(same_bits(from_before.state(), grains.state()));
  Grains from_after(load_grains(save_grains(after)));
  from_after.step(99);
  CHECK(same_bits(from_after.state(), grains.state()));
  from_after.restore(before);
  from_after.step(100);
  CHECK(same_bits(from_after.state(), grains.state()));
}

TEST_CASE("Grains: the margins of the neighbour lists change nothing but round-off") {
  const auto run = [](const NeighbourMargin& margin) {
    GrainState state = test::lattice(6);
    test::shake(state, 0.05);
    Grains grains(state);
    grains.set_margin(margin);
    grains.drive(shearing());
    grains.step(300);
    return grains.state();
  };
  const GrainState narrow = run({2e-5, 2e-6}), wide = run({1e-3, 2e-4});
  REQUIRE(narrow.sorts > wide.sorts + 5);
  CHECK(narrow.neighbours.near.size() < wide.neighbours.near.size());
  CHECK(largest_difference(narrow, wide) < 1e-12);
  CHECK(largest_difference(narrow, test::lattice(6)) > 1e-6);
}

TEST_CASE("Grains: a step far too long for the stiffness is noticed") {
  GrainState state = test::lattice(4);
  state.time_step_s = 1e-4;
  Grains grains(state);
  CHECK(grains.step(10000) < 10000);
}

TEST_CASE("Grains: motion is taken out, and given to one grain") {
  Grains grains = sheared(4, 1);
  grains.step(10);
  REQUIRE(kinetic_energy(grains.state()) > 0);
  grains.stop_motion();
  CHECK(kinetic_energy(grains.state()) == 0);
  grains.set_velocity(3, {0.1, 0.2, 0.3});
  const Grain& g = grains.state().grains[3];
  CHECK(kinetic_energy(grains.state()) == Approx(0.5 * 0.14 * test::mass(g)));
}

TEST_CASE("Grains: what cannot be run is refused") {
  CHECK_THROWS_AS(Grains(test::lattice(2), 0), std::invalid_argument);
  CHECK_THROWS_AS(Grains(test::lattice(2), 65), std::invalid_argument);
}
