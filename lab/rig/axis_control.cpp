// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/axis_control.hpp"

#include <utility>

namespace triax::lab {

void AxisControl::begin_stage(const Stage& stage, const Seen& seen, double true_force_n) {
  *this = AxisControl(servo_);
  area_.start(seen.steady_area_m2(), 0);
  stage_ = stage;
  force_at_start_ = seen[Quantity::axial_force];
  dead_force_ = true_force_n + stage.load_step_n;
  q_at_start_ = seen.state().q;
  if (by_force(stage.axial)) wanted_ = force_at_start_;
  trim_ = true_force_n - force_at_start_;
  stress_ = q_at_start_;
}

void AxisControl::resume(const Seen& seen, double true_force_n) {
  trim_ = true_force_n - seen[Quantity::axial_force];
}

/// Without a filter the last two areas tell.
void AxisControl::smooth_area(const Seen& seen, double dt_s) {
  if (area_.active()) area_.take(seen.steady_area_m2(), dt_s);
  next_area_ = area_.active() ? area_.expected(dt_s) : seen.next_area_m2();
}

bool AxisControl::follows_area() const { return servo_.ideal && way_of(stage_.axial).stress; }

/// What the servo is to hold at the end of the tick: a deviator stress on the area then, or a
/// force.
void AxisControl::want(const AxisView& view) {
  const AxialWay& way = way_of(stage_.axial);
  if (way.stress == nullptr) {
    wanted_ = way.force(stage_, view);
    return;
  }
  const double stress = way.stress(stage_, view);
  wanted_ = stress * next_area_ + stage_.load_step_n;
  if (follows_area()) stress_ = stress;
}

void AxisControl::follow_area(const Seen& seen, double start_stress, AxisDemand& d) const {
  d.area_m2 = seen.steady_area_m2();
  d.start_stress_pa = start_stress;
  d.stress_pa = stress_;
  d.force_n = stage_.load_step_n + trim_;
}

AxisDemand AxisControl::demand(const Seen& seen, double next_cell_pa, double dt_s) {
  AxisDemand d;
  const bool first = std::exchange(first_, false);
  const AxialWay::Drive drive = way_of(stage_.axial).drive;
  if (drive == AxialWay::Drive::none) return d;
  if (drive == AxialWay::Drive::crosshead) {
    d.kind = AxisDemand::Kind::crosshead;
    d.velocity_m_per_s = stage_.axial_rate_m_per_s;
    d.spring_n_per_m = stage_.spring_stiffness_n_per_m;
    return d;
  }
  d.kind = AxisDemand::Kind::force;
  d.dead = drive == AxialWay::Drive::masses;
  if (first) {
    d.impulse_n_s = stage_.impulse_n_s;
    d.perturbed = stage_.impulse_n_s != 0 || stage_.load_step_n != 0;
  }
  if (d.dead) {
    wanted_ = force_at_start_ + stage_.load_step_n;
    d.start_force_n = d.force_n = dead_force_;
    return d;
  }
  smooth_area(seen, dt_s);
  if (follows_area() && !first) wanted_ = stress_ * seen.steady_area_m2() + stage_.load_step_n;
  if (!first) trim_ += kTrim_per_s * dt_s * (*wanted_ - seen[Quantity::axial_force]);
  d.start_force_n = *wanted_ + trim_;
  const double start_stress = stress_;
  want({.force_at_start_n = force_at_start_,
        .q_at_start_pa = q_at_start_,
        .stage_time_s = seen.stage_time_s() + dt_s,
        .cell_pa = next_cell_pa,
        .pore_pa = seen[Quantity::pore_pressure]});
  d.force_n = *wanted_ + trim_;
  if (follows_area()) follow_area(seen, start_stress, d);
  return d;
}

}  // namespace triax::lab
