// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/probes/contact_increment.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace triax::sim {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// sin(x/2)/x and cos(x/2) keep small turns to round-off.
Quaterniond turn_of(const Vector3d& rotation) {
  const double angle = rotation.norm();
  const double scale = angle > 1e-6 ? std::sin(0.5 * angle) / angle : 0.5;
  const Vector3d v = scale * rotation;
  return {std::cos(0.5 * angle), v.x(), v.y(), v.z()};
}

/// The smallest turn from one direction to the other; about any axis where they are opposite.
Quaterniond turn_between(const Vector3d& from, const Vector3d& to) {
  const Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  if (cosine < -1 + 1e-12) {
    const Vector3d axis = a.unitOrthogonal();
    return {0, axis.x(), axis.y(), axis.z()};
  }
  const double s = std::sqrt((1 + cosine) * 2);
  const Vector3d v = a.cross(b) * (1 / s);
  return {0.5 * s, v.x(), v.y(), v.z()};
}

Vector3d rotation_of(Quaterniond q) {
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  if (sine < 1e-9) return 2 * q.vec();
  return 2 * std::atan2(sine, q.w()) / sine * q.vec();
}

double twist_about(const Vector3d& normal, const Quaterniond& q) {
  return 2 * std::atan2(q.vec().dot(normal), q.w());
}

/// A contact in the frame at rest.
struct AtRest {
  Vector3d force, arm_a, arm_b;  // of b on a; from the centres
  AtRest(const ContactInstant& c, double half_difference) {
    const double distance = c.branch_m.norm();
    const Vector3d normal = c.branch_m / distance;
    force = c.tangential_n - c.normal_force_n * normal;
    arm_a = (0.5 * distance + half_difference) * normal;
    arm_b = (half_difference - 0.5 * distance) * normal;
  }
};

void add_at_rest(ContactIncrement& increment, const AtRest& from, const AtRest& to,
                 const Vector3d& branch_change, const Vector3d& turn_a, const Vector3d& turn_b,
                 const Vector3d& frame_turn) {
  const Vector3d force_change = to.force - from.force, force = 0.5 * (to.force + from.force);
  const Vector3d arm_a = 0.5 * (from.arm_a + to.arm_a), arm_b = 0.5 * (from.arm_b + to.arm_b);
  const Vector3d way = branch_change + turn_b.cross(arm_b) - turn_a.cross(arm_a);
  increment.at_rest_work = force_change.dot(branch_change);
  increment.frame_turning = -frame_turn.cross(force).dot(way);
  increment.grain_turning = turn_a.dot((to.arm_a - from.arm_a).cross(force)) -
                            turn_b.dot((to.arm_b - from.arm_b).cross(force));
  increment.force_change_n = force_change;
  increment.moment_change_a_nm = to.arm_a.cross(to.force) - from.arm_a.cross(from.force);
  increment.moment_change_b_nm = from.arm_b.cross(from.force) - to.arm_b.cross(to.force);
}

}  // namespace

ContactIncrement contact_increment(const ContactInstant& before, const ContactInstant& after,
                                   double radius_a_m, double radius_b_m, const Vector3d& turn_a,
                                   const Vector3d& turn_b) {
  const double distance0 = before.branch_m.norm(), distance1 = after.branch_m.norm();
  const Vector3d normal = before.branch_m / distance0;
  const Quaterniond tilt = turn_between(before.branch_m, after.branch_m);
  const Quaterniond a = tilt.conjugate() * turn_of(turn_a), b = tilt.conjugate() * turn_of(turn_b);
  const double twist = 0.5 * (twist_about(normal, a) + twist_about(normal, b));
  const Quaterniond about = turn_of(twist * normal), frame = tilt * about;

  const Vector3d relative_a = rotation_of(about.conjugate() * a),
                 relative_b = rotation_of(about.conjugate() * b);
  const double middle = 0.25 * (distance0 + distance1),
               half_difference = 0.5 * (radius_a_m - radius_b_m);
  const Vector3d rolled =
      relative_a * (middle + half_difference) + relative_b * (middle - half_difference);
  const Vector3d slip = -rolled.cross(normal);

  ContactIncrement increment;
  increment.normal_work = (after.normal_force_n - before.normal_force_n) * (distance0 - distance1);
  increment.tangential_work =
      (frame.conjugate() * after.tangential_n - before.tangential_n).dot(slip);
  add_at_rest(increment, {before, half_difference}, {after, half_difference},
              after.branch_m - before.branch_m, turn_a, turn_b, rotation_of(frame));
  return increment;
}

}  // namespace triax::sim
