// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/walls.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace triax::sim {
namespace {

using Kind = AxisDrive::Kind;

constexpr double kGain = 0.05, kSmoothing = 0.1;
/// Share of the asked rate that is learned in a step: slow against the waves through the box.
constexpr double kLearning = 1.0 / 500;
/// Stiffness of an axis is taken as at least this share of E: nothing may touch yet.
constexpr double kLeastStiffness = 0.01;

bool follows(const WallState& walls, int axis, int leader) {
  return walls.drive[axis].kind == Kind::follows && walls.drive[axis].leader == leader;
}

/// dσ/dε of one axis if its walls moved and nothing else did, Pa.
double axis_stiffness(const GrainState& s, int axis) {
  const auto& k = s.walls.stiffness_n_per_m;
  const double touching =
      0.5 * (k[2 * axis] + k[2 * axis + 1]) * 0.5 * s.box.length_m(axis) / s.box.area_m2(axis);
  return std::max(touching, kLeastStiffness * s.law.stiffness_over_diameter_pa);
}

double conjugate_stiffness(const GrainState& s, int axis) {
  double sum = axis_stiffness(s, axis);
  for (int a = 0; a < 3; ++a)
    if (follows(s.walls, a, axis)) {
      const double ratio = s.walls.drive[a].ratio;
      sum += ratio * ratio * axis_stiffness(s, a);
    }
  return sum;
}

bool strained(const WallState& walls) {
  return std::any_of(walls.drive.begin(), walls.drive.end(), [](const AxisDrive& d) {
    return d.kind == Kind::strain_rate && d.strain_rate_per_s != 0;
  });
}

double servo_rate(GrainState& s, int axis) {
  const AxisDrive& drive = s.walls.drive[axis];
  double& target = s.walls.stress_target_pa[axis];
  if (drive.stress_rate_pa_per_s > 0) {
    const double most = drive.stress_rate_pa_per_s * s.time_step_s;
    target += std::clamp(drive.stress_goal_pa - target, -most, most);
  } else {
    target = drive.stress_goal_pa;
  }
  const double error = target - conjugate_stress(s.walls, s.box, axis);
  const double limit = 2 * drive.speed_limit_m_per_s / s.box.length_m(axis);
  const double asked = kGain * error / (conjugate_stiffness(s, axis) * s.time_step_s);
  double& learned = s.walls.learned_rate_per_s[axis];
  const double wanted = asked + learned;
  if (strained(s.walls) && std::abs(wanted) < limit) learned += kLearning * asked;
  return (1 - kSmoothing) * s.walls.strain_rate_per_s[axis] +
         kSmoothing * std::clamp(wanted, -limit, limit);
}

}  // namespace

double wall_stress(const WallState& walls, const GrainBox& box, int axis) {
  return 0.5 * (walls.force_n[2 * axis] + walls.force_n[2 * axis + 1]) / box.area_m2(axis);
}

double conjugate_stress(const WallState& walls, const GrainBox& box, int axis) {
  double stress = wall_stress(walls, box, axis);
  for (int a = 0; a < 3; ++a)
    if (follows(walls, a, axis)) stress += walls.drive[a].ratio * wall_stress(walls, box, a);
  return stress;
}

void move_walls(GrainState& s) {
  auto& rate = s.walls.strain_rate_per_s;
  std::array<double, 3> next{};
  for (int a = 0; a < 3; ++a) {
    const AxisDrive& drive = s.walls.drive[a];
    if (drive.kind == Kind::strain_rate) next[a] = drive.strain_rate_per_s;
    if (drive.kind == Kind::stress) next[a] = servo_rate(s, a);
  }
  for (int a = 0; a < 3; ++a)
    if (s.walls.drive[a].kind == Kind::follows)
      next[a] = s.walls.drive[a].ratio * next[s.walls.drive[a].leader];
  rate = next;
  for (int a = 0; a < 3; ++a) {
    // By the natural strain itself, so that strains that cancel keep the volume to round-off.
    const double travel = -0.5 * std::expm1(-rate[a] * s.time_step_s) * s.box.length_m(a);
    s.box.low_m[a] += travel;
    s.box.high_m[a] -= travel;
  }
}

void check(const std::array<AxisDrive, 3>& drives) {
  for (const AxisDrive& d : drives) {
    if (!std::isfinite(d.ratio) || !std::isfinite(d.strain_rate_per_s) ||
        !std::isfinite(d.stress_goal_pa))
      throw std::invalid_argument("drive of an axis: a value is not finite");
    if (!(d.stress_rate_pa_per_s >= 0))
      throw std::invalid_argument("drive of an axis: the stress rate must not be below 0");
    if (!(d.speed_limit_m_per_s > 0))
      throw std::invalid_argument("drive of an axis: the speed limit must be above 0");
    if (d.kind == Kind::follows && (d.leader > 2 || drives[d.leader].kind == Kind::follows))
      throw std::invalid_argument(
          "drive of an axis: it must follow an axis that has its own drive");
  }
}

double wall_speed(const GrainState& s) {
  double speed = 0;
  for (int a = 0; a < 3; ++a)
    speed = std::max(speed, 0.5 * std::abs(s.walls.strain_rate_per_s[a]) * s.box.length_m(a));
  return speed;
}

}  // namespace triax::sim
