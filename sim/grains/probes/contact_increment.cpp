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
  return increment;
}

}  // namespace triax::sim
