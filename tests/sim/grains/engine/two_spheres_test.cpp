// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms of one contact.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sim/grains/engine/grains.hpp"
#include "sim/grains/state/grain_measures.hpp"
#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;
using std::numbers::pi;

namespace {

/// Masses so large that nothing moves but as its velocity says.
ContactLaw immovable(double friction_angle) {
  ContactLaw law = test::undamped(friction_angle);
  law.density_kg_per_m3 = 1e15;
  return law;
}

/// Steps until the two spheres no longer touch.
int steps_of_contact(Grains& grains) {
  int steps = 0;
  do {
    grains.step(1);
    ++steps;
  } while (!contacts_of(grains.state()).empty() && steps < 1000000);
  return steps;
}

Eigen::Vector3d tangential(const GrainState& state) {
  const auto& t = state.neighbours.near.tangential_n;
  return {t[0].at(0), t[1].at(0), t[2].at(0)};
}

}  // namespace

TEST_CASE("Grains: two spheres repel each other with k_n times their overlap") {
  const double r1 = 1e-3, r2 = 3e-3, overlap = 2e-6, step = 1e-7;
  Grains grains(test::pair_of(r1, r2, overlap, test::undamped(), step));
  grains.step(1);
  const double force = normal_stiffness(ContactLaw{}, r1, r2) * overlap;
  const Grain &a = test::grain(grains.state(), 0), &b = test::grain(grains.state(), 1);
  CHECK(test::mass(a) == Approx(3000 * 4 * pi / 3 * r1 * r1 * r1));
  CHECK(a.velocity[0] == Approx(-force / test::mass(a) * step).epsilon(1e-9));
  CHECK(b.velocity[0] == Approx(force / test::mass(b) * step).epsilon(1e-9));
  const auto contacts = contacts_of(grains.state());
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].normal_force_n == Approx(force).epsilon(1e-9));
}

TEST_CASE("Grains: two spheres that do not touch feel nothing, however close") {
  Grains grains(test::pair_of(1e-3, 1e-3, -1e-9, test::undamped()));
  grains.step(10);
  CHECK(test::grain(grains.state(), 0).velocity[0] == 0);
  CHECK(contacts_of(grains.state()).empty());
}

TEST_CASE("Grains: a collision lasts half a period 2 pi sqrt(m*/k) and reverses the velocity") {
  const double r1 = 1e-3, r2 = 2e-3, speed = 0.01, step = 2e-8;
  GrainState state = test::pair_of(r1, r2, 0, test::undamped(), step);
  test::grain(state, 0).velocity[0] = speed;
  const double m1 = test::mass(test::grain(state, 0)), m2 = test::mass(test::grain(state, 1));
  const double reduced = m1 * m2 / (m1 + m2);
  const double half_period = pi * std::sqrt(reduced / normal_stiffness(state.law, r1, r2));
  Grains grains(state);
  grains.step(1);
  const int steps = steps_of_contact(grains);
  CHECK(steps * step == Approx(half_period).margin(3 * step));
  REQUIRE(steps > 300);
  const double v1 = test::grain(grains.state(), 0).velocity[0],
               v2 = test::grain(grains.state(), 1).velocity[0];
  CHECK(v2 - v1 == Approx(speed).epsilon(1e-4));
  CHECK(kinetic_energy(grains.state()) == Approx(0.5 * m1 * speed * speed).epsilon(1e-4));
}

TEST_CASE("Grains: a sphere held between two walls swings with 2 pi sqrt(m/2k)") {
  const double r = 1e-3, held = 1e-5, step = 1e-8;
  GrainBox box = test::far_walls();
  box.low_m[0] = -r + held;
  box.high_m[0] = r - held;
  GrainState state = make_grain_state({{{0, 0, 0}, r}}, box, test::undamped(), step);
  state.grains[0].velocity[0] = 1e-4;
  const double period =
      2 * pi * std::sqrt(test::mass(state.grains[0]) / (2 * wall_stiffness(state.law, r)));
  Grains grains(state);
  int upwards = 0, steps = 0, first = 0;
  for (double before = 1; upwards < 11; ++steps) {
    grains.step(1);
    const double now = grains.state().grains[0].position[0];
    if (before < 0 && now >= 0 && ++upwards == 1) first = steps;
    before = now;
    REQUIRE(steps < 1000000);
  }
  CHECK((steps - 1 - first) * step / 10 == Approx(period).epsilon(1e-3));
  CHECK(grains.state().walls.force_n[0] + grains.state().walls.force_n[1] ==
        Approx(2 * wall_stiffness(state.law, r) * held));
}

TEST_CASE("Grains: the tangential force is k_t times the displacement below Coulomb's limit") {
  const double overlap = 1e-5, speed = 1e-3, step = 1e-6;
  GrainState state = test::pair_of(1e-3, 2e-3, overlap, immovable(0.6), step);
  test::grain(state, 1).velocity[1] = speed;
  const double k = normal_stiffness(state.law, 1e-3, 2e-3);
  Grains grains(state);
  grains.step(100);
  const auto contacts = contacts_of(grains.state());
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].tangential_force_n == Approx(0.42 * k * speed * 100 * step).epsilon(1e-3));
  CHECK_FALSE(contacts[0].slides);
}

TEST_CASE("Grains: a contact slides at tan phi times its normal force") {
  const double overlap = 1e-6, step = 1e-6, angle = 0.5;
  GrainState state = test::pair_of(1e-3, 2e-3, overlap, immovable(angle), step);
  test::grain(state, 1).velocity[2] = 0.1;
  Grains grains(state);
  grains.step(50);
  const auto contacts = contacts_of(grains.state());
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].slides);
  CHECK(contacts[0].tangential_force_n ==
        Approx(std::tan(angle) * contacts[0].normal_force_n).epsilon(1e-8));
  CHECK(contacts[0].force_n.dot(contacts[0].normal) == Approx(-contacts[0].normal_force_n));
  CHECK(measure(grains.state()).sliding_contacts == 1);
}

TEST_CASE("Grains: spheres that roll on each other like gears build up no force") {
  GrainState state = test::pair_of(1e-3, 2e-3, 1e-6, immovable(0.6), 1e-6);
  const double arm_a = 1e-3 - 0.5e-6, arm_b = 2e-3 - 0.5e-6;
  test::grain(state, 0).spin[2] = 10;
  test::grain(state, 1).spin[2] = -10 * arm_a / arm_b;
  Grains grains(state);
  grains.step(1000);
  const auto contacts = contacts_of(grains.state());
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].tangential_force_n < 1e-9 * contacts[0].normal_force_n);
  CHECK(contacts[0].normal_force_n > 0);
}

TEST_CASE("Grains: friction turns sliding into rolling at 5/7 of the speed") {
  // Pressed by a frictionless wall on a sphere so large that it is a plane and so heavy that it
  // rests. Later, the spring of the contact makes the speed swing about the closed form.
  const double r = 1e-3, plane = 0.2, held = 1e-6, speed = 0.01;
  GrainBox box = test::far_walls();
  box.high_m[0] = plane + 2 * r - 2 * held;
  const Sphere small{{plane + r - held, 0, 0}, r};
  GrainState state =
      make_grain_state({small, {{0, 0, 0}, plane}}, box, test::undamped(0.002), 1e-7);
  test::grain(state, 0).velocity[1] = speed;
  Grains grains(state);
  grains.step(10);
  CHECK(measure(grains.state()).sliding_contacts == 1);
  grains.step(490);
  const int samples = 1000;
  double velocity = 0, spin = 0;
  for (int s = 0; s < samples; ++s) {
    grains.step(1);
    velocity += test::grain(grains.state(), 0).velocity[1] / samples;
    spin += test::grain(grains.state(), 0).spin[2] / samples;
  }
  CHECK(velocity == Approx(speed * 5 / 7).epsilon(0.01));
  CHECK(std::abs(spin) * r == Approx(speed * 5 / 7).epsilon(0.01));
}

TEST_CASE("Grains: a tangential force turns with a contact that spins about its normal") {
  const int steps = 1000;
  GrainState state = test::pair_of(1e-3, 2e-3, 1e-5, immovable(0.6), 1e-6);
  for (Grain& g : state.grains) g.spin[0] = pi / 2 / (steps * state.time_step_s);
  state.neighbours.near.tangential_n[1].at(0) = 0.5;
  Grains grains(state);
  grains.step(steps);
  const Eigen::Vector3d force = tangential(grains.state());
  CHECK(force.z() == Approx(0.5).epsilon(2e-3));
  CHECK(std::abs(force.x()) + std::abs(force.y()) < 1e-3);
}

TEST_CASE("Grains: a tangential force turns with a pair that turns as one body") {
  const int steps = 2000;
  const double step = 1e-6, rate = pi / 2 / (steps * step), apart = 3e-3 - 1e-5;
  GrainState state = test::pair_of(1e-3, 2e-3, 1e-5, immovable(0.6), step);
  state.neighbours.near.tangential_n[1].at(0) = 0.5;
  for (Grain& g : state.grains) g.spin[2] = rate;
  Grains grains(state);
  for (int s = 0; s < steps; ++s) {
    GrainState now = grains.state();
    const double angle = rate * step * s, middle = angle - 0.5 * rate * step;
    const bool first_is_origin = now.ids[0] == 0;
    Grain& far = now.grains[first_is_origin ? 1 : 0];
    far.position[0] = apart * std::cos(angle);
    far.position[1] = apart * std::sin(angle);
    far.velocity[0] = -apart * rate * std::sin(middle);
    far.velocity[1] = apart * rate * std::cos(middle);
    grains.restore(now);
    grains.step(1);
  }
  const Eigen::Vector3d force = tangential(grains.state());
  CHECK(force.norm() == Approx(0.5).epsilon(2e-3));
  CHECK(std::abs(force.x()) == Approx(0.5).epsilon(2e-3));
}
