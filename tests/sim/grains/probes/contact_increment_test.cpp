// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/probes/contact_increment.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

using namespace triax::sim;
using Eigen::Vector3d;

namespace {

constexpr double kRadiusA = 2e-3, kRadiusB = 3e-3;
const Vector3d kBranch(4.9e-3, 0, 0), kNone = Vector3d::Zero();

}  // namespace

TEST_CASE("Contact increment: along the normal it is the force's change times the overlap's") {
  const ContactIncrement w = contact_increment({kBranch, 10, kNone}, {0.998 * kBranch, 14, kNone},
                                               kRadiusA, kRadiusB, kNone, kNone);
  CHECK(w.normal_work == Approx(4 * 0.002 * 4.9e-3));
  CHECK(w.tangential_work == 0);
}

TEST_CASE("Contact increment: an elastic tangential spring gives k u²") {
  // b moves sideways by u: seen from the turning line of centres both grains turn back.
  const double u = 1e-7, stiffness = 1e5;
  const ContactIncrement w = contact_increment(
      {kBranch, 10, {0, 1, 0}}, {kBranch + Vector3d(0, u, 0), 10, {0, 1 + stiffness * u, 0}},
      kRadiusA, kRadiusB, kNone, kNone);
  CHECK(w.tangential_work == Approx(stiffness * u * u).epsilon(1e-4));
  // Grain a turns about z by θ: its surface moves by a θ along y, b's stays.
  const double arm = 2e-3 - 0.05e-3, theta = 1e-5;
  const ContactIncrement turned =
      contact_increment({kBranch, 10, kNone}, {kBranch, 10, {0, -stiffness * arm * theta, 0}},
                        kRadiusA, kRadiusB, {0, 0, theta}, kNone);
  CHECK(turned.tangential_work == Approx(stiffness * arm * theta * arm * theta).epsilon(1e-4));
}

TEST_CASE("Contact increment: rolling without sliding does no work") {
  const double arm_a = 1.95e-3, arm_b = 2.95e-3, theta = 1e-4;
  const ContactIncrement w =
      contact_increment({kBranch, 10, {0, 1, 0}}, {kBranch, 10, {0, 3, 0}}, kRadiusA, kRadiusB,
                        {0, 0, theta}, {0, 0, -theta * arm_a / arm_b});
  CHECK(std::abs(w.tangential_work) < 1e-12 * 2 * arm_a * theta + 1e-20);
}

TEST_CASE("Contact increment: a motion of the whole adds nothing, however far it turns") {
  const Vector3d axis = Vector3d(1, -2, 0.5).normalized();
  const ContactInstant before{kBranch, 10, {0, 1, 2}};
  const ContactInstant after{kBranch + Vector3d(1e-6, 2e-6, -1e-6), 12, {0, 1.5, 1.8}};
  const Vector3d turn_a(1e-4, 2e-4, -1e-4), turn_b(-3e-4, 1e-4, 2e-4);
  const ContactIncrement rest =
      contact_increment(before, after, kRadiusA, kRadiusB, turn_a, turn_b);
  for (const double angle : {1e-3, 0.3, 1.5}) {
    const Eigen::Matrix3d q = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    const auto turned = [&](const Vector3d& t) {
      const Eigen::AngleAxisd whole(
          Eigen::Matrix3d(q * Eigen::AngleAxisd(t.norm(), t.normalized()).toRotationMatrix()));
      return Vector3d(whole.angle() * whole.axis());
    };
    const ContactIncrement moved = contact_increment(
        before, {q * after.branch_m, after.normal_force_n, q * after.tangential_n}, kRadiusA,
        kRadiusB, turned(turn_a), turned(turn_b));
    CHECK(moved.normal_work == Approx(rest.normal_work).epsilon(1e-9));
    CHECK(moved.tangential_work == Approx(rest.tangential_work).epsilon(1e-8));
  }
  CHECK(rest.tangential_work != 0);
}

TEST_CASE(
    "Contact increment: what both frames differ by is the turning of contact and grains under the "
    "mean force, to the third order") {
  const auto left = [](double size) {
    const ContactInstant before{kBranch, 10, {0, 1, 2}};
    const Vector3d way(1e-6, 8e-6, -5e-6), turn_a(1e-3, 2e-3, -1e-3), turn_b(-3e-3, 1e-3, 2e-3);
    const Vector3d branch = kBranch + size * way;
    Vector3d tangential = Vector3d(0, 1, 2) + size * Vector3d(0, 0.5, -0.2);
    tangential -= tangential.dot(branch) / branch.squaredNorm() * branch;
    const ContactInstant after{branch, 10 + 2 * size, tangential};
    const ContactIncrement w =
        contact_increment(before, after, kRadiusA, kRadiusB, size * turn_a, size * turn_b);
    const double moments =
        size * (turn_a.dot(w.moment_change_a_nm) + turn_b.dot(w.moment_change_b_nm));
    const double error = w.normal_work + w.tangential_work - w.at_rest_work + moments -
                         w.frame_turning - w.grain_turning;
    for (const double part : {w.frame_turning, w.grain_turning, moments})
      CHECK(std::abs(part) > 10 * std::abs(error));
    return error;
  };
  CHECK(left(0.5) / left(0.25) == Approx(16).epsilon(0.1));
}

TEST_CASE("Contact increment: a chain that tilts under a force gives way by F u²/l") {
  // No moment, no turn of grains: b moves sideways by u past a.
  const double force = 10, u = 1e-6;
  const ContactIncrement w =
      contact_increment({kBranch, force, kNone}, {kBranch + Vector3d(0, u, 0), force, kNone},
                        kRadiusA, kRadiusB, kNone, kNone);
  CHECK(w.at_rest_work == Approx(-force * u * u / kBranch.x()).epsilon(1e-6));
  CHECK(w.frame_turning == Approx(force * u * u / kBranch.x()).epsilon(1e-6));
  CHECK(w.grain_turning == 0);
}
