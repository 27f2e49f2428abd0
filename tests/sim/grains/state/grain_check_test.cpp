// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/grain_check.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <stdexcept>
#include <string>

#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;
using Catch::Contains;

namespace {

GrainState driven_state() {
  Grains grains(test::lattice(4));
  grains.drive({stress_drive(1e4), strain_rate_drive(0.3), following_drive(1, -0.5)});
  grains.step(40);
  return grains.state();
}

/// Why the state is refused, also once its bytes were sealed again; empty if it is not.
template <class Change>
std::string refusal(const Change& change) {
  GrainState state = driven_state();
  change(state);
  std::string why;
  try {
    check(state);
  } catch (const std::invalid_argument& error) {
    why = error.what();
  }
  if (why.empty()) {
    CHECK(load_grains(save_grains(state)) == state);
  } else {
    CHECK(why.find('\n') == std::string::npos);
    CHECK_THROWS_AS(load_grains(save_grains(state)), std::invalid_argument);
  }
  return why;
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("Grain check: states that the engine made are accepted, in every regime") {
  CHECK(refusal([](GrainState&) {}).empty());
  CHECK_NOTHROW(check(test::pair_of(1e-3, 2e-3, 1e-5, test::undamped())));
  GrainState shaken = test::lattice(3);
  test::shake(shaken, 0.5);
  Grains grains(shaken);
  for (int k = 0; k < 20; ++k) {
    grains.step(10);
    CHECK_NOTHROW(check(grains.state()));
  }
  grains.set_margin({1e-3, 1e-4});
  CHECK_NOTHROW(check(grains.state()));
}

TEST_CASE("Grain check: settings that no step survives are refused") {
  for (const double bad : {0.0, -1e-6, kNan, kInfinity})
    CHECK_THAT(refusal([&](GrainState& s) { s.time_step_s = bad; }), Contains("time step"));
  for (const double bad : {kNan, kInfinity, -1.0, 1e300})
    CHECK_THAT(refusal([&](GrainState& s) { s.box.high_m[1] = bad; }), Contains("the box"));
  CHECK_THAT(refusal([](GrainState& s) { s.box.high_m[1] = s.box.low_m[1]; }), Contains("the box"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.box_when_sorted.low_m[0] = kNan; }),
             Contains("the box"));
  CHECK_THAT(refusal([](GrainState& s) { s.law.damping = 2; }), Contains("damping"));
  CHECK_THAT(refusal([](GrainState& s) { s.law.reading = static_cast<StiffnessReading>(7); }),
             Contains("reading"));
  CHECK_THAT(refusal([](GrainState& s) { s.law.stiffness_over_diameter_pa = 1e300; }),
             Contains("too large"));
  CHECK_THAT(refusal([](GrainState& s) { s.margin.near_m = s.margin.listed_m; }),
             Contains("margins"));
  CHECK_THAT(refusal([](GrainState& s) { s.margin.listed_m = 1; }), Contains("margin"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.travelled_m = kNan; }),
             Contains("travelled"));
  CHECK_THAT(refusal([](GrainState& s) { s.steps = -1; }), Contains("steps"));
  CHECK_THAT(refusal([](GrainState& s) { s.time_s = kNan; }), Contains("time"));
}

TEST_CASE("Grain check: walls that would jump are refused") {
  CHECK_THAT(refusal([](GrainState& s) { s.walls.strain_rate_per_s[0] = kNan; }),
             Contains("too far"));
  CHECK_THAT(refusal([](GrainState& s) { s.walls.learned_rate_per_s[2] = kNan; }),
             Contains("too far"));
  CHECK_THAT(refusal([](GrainState& s) { s.walls.strain_rate_per_s[0] = 1e9; }),
             Contains("too far"));
  CHECK_THAT(refusal([](GrainState& s) { s.walls.drive[1].strain_rate_per_s = 1e9; }),
             Contains("too far"));
  CHECK_THAT(refusal([](GrainState& s) { s.walls.drive[0].speed_limit_m_per_s = 1e9; }),
             Contains("too far"));
  CHECK_THAT(refusal([](GrainState& s) { s.walls.drive[2].ratio = 1e9; }), Contains("too far"));
  CHECK_THAT(refusal([](GrainState& s) { s.walls.drive[2].leader = 2; }), Contains("follow"));
  CHECK_THAT(refusal([](GrainState& s) { s.walls.drive[2].leader = 200; }), Contains("follow"));
  CHECK_THAT(
      refusal([](GrainState& s) { s.walls.drive[0].kind = static_cast<AxisDrive::Kind>(9); }),
      Contains("no such drive"));
  CHECK_THAT(refusal([](GrainState& s) { s.walls.force_n[5] = kInfinity; }), Contains("walls"));
  CHECK_THAT(refusal([](GrainState& s) { s.walls.stiffness_n_per_m[5] = -1; }), Contains("wall"));
  CHECK_THAT(refusal([](GrainState& s) { s.walls.stress_target_pa[0] = kNan; }), Contains("walls"));
}

TEST_CASE("Grain check: grains that are none are refused") {
  for (const double bad : {0.0, -1e-3, kNan, kInfinity})
    CHECK_THAT(refusal([&](GrainState& s) { s.grains[7].radius = bad; }), Contains("radius"));
  for (const double bad : {0.0, -1e3, kNan, kInfinity, 1e3}) {
    CHECK_THAT(refusal([&](GrainState& s) { s.grains[7].inverse_mass = bad; }), Contains("mass"));
    CHECK_THAT(refusal([&](GrainState& s) { s.grains[7].inverse_inertia = bad; }),
               Contains("mass"));
  }
  CHECK_THAT(refusal([](GrainState& s) { s.grains[7].position[2] = kNan; }), Contains("outside"));
  CHECK_THAT(refusal([](GrainState& s) { s.grains[7].position[2] = 1; }), Contains("outside"));
  CHECK_THAT(refusal([](GrainState& s) { s.grains[7].velocity[0] = kNan; }), Contains("motion"));
  CHECK_THAT(refusal([](GrainState& s) { s.grains[7].spin[1] = kInfinity; }), Contains("motion"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.sorted_at_m[7][1] = kNan; }),
             Contains("place"));
  CHECK_THAT(refusal([](GrainState& s) { s.ids[3] = s.ids[4]; }), Contains("ids"));
  CHECK_THAT(refusal([](GrainState& s) { s.ids[3] = -1; }), Contains("ids"));
  CHECK_THAT(refusal([](GrainState& s) { s.ids.pop_back(); }), Contains("length"));
  CHECK_THAT(refusal([](GrainState& s) { s.grains.clear(); }), Contains("length"));
}

TEST_CASE("Grain check: lists that would be read outside or in disorder are refused") {
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.listed_j.back() = 64; }),
             Contains("not there"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.listed_i[0] = -1; }), Contains("not there"));
  CHECK_THAT(
      refusal([](GrainState& s) { std::swap(s.neighbours.listed_j[0], s.neighbours.listed_j[1]); }),
      Contains("order"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.listed_j.pop_back(); }), Contains("length"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.near.listed[0] = 1 << 30; }),
             Contains("listed one"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.near.listed[1] = 0; }),
             Contains("listed one"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.near.j[0] += 1; }), Contains("listed one"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.near.j.pop_back(); }), Contains("length"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.near.tangential_n[1].pop_back(); }),
             Contains("tangential"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.near.tangential_n[1][0] = kNan; }),
             Contains("tangential"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.near.stiffness_n_per_m[0] = kNan; }),
             Contains("sizes"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.near.reach_m[0] *= 2; }), Contains("sizes"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.near.half_difference_m[0] += 1; }),
             Contains("sizes"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.near_wall[0].push_back(0); }),
             Contains("order"));
  CHECK_THAT(refusal([](GrainState& s) { s.neighbours.near_wall[0] = {63}; }),
             Contains("not listed there"));
  CHECK_THAT(refusal([](GrainState& s) {
               s.neighbours.near_wall[0].clear();
               s.neighbours.listed_at_wall[0].push_back(64);
             }),
             Contains("not there"));
}
