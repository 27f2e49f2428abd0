#include "lab/rig/axis_control.hpp"

#include <utility>

namespace triax::lab {

void AxisControl::begin_stage(const Stage& stage, const Seen& seen, double true_force_n) {
  *this = AxisControl(servo_);
  area_.start(seen.steady_area_m2(), 0);
  stage_ = stage;
  force_at_start_ = seen[Quantity::axial_force];
  dead_force_ = true_force_n + stage.load_step_n;
  held_q_ = stage.held_q_pa.value_or(seen.state().q);
  if (by_force(stage.axial)) wanted_ = force_at_start_;
  trim_ = true_force_n - force_at_start_;
  stress_ = seen.state().q;
}

void AxisControl::resume(const Seen& seen, double true_force_n) {
  trim_ = true_force_n - seen[Quantity::axial_force];
}

/// Without a filter the last two areas tell.
void AxisControl::smooth_area(const Seen& seen, double dt_s) {
  if (area_.active()) area_.take(seen.steady_area_m2(), dt_s);
  next_area_ = area_.active() ? area_.expected(dt_s) : seen.next_area_m2();
}

bool AxisControl::follows_area() const {
  return servo_.ideal &&
         (stage_.axial == AxialAction::constant_q || stage_.axial == AxialAction::stress_ratio);
}

double AxisControl::wanted_stress(const Seen& seen, double next_cell_pa) const {
  if (stage_.axial == AxialAction::constant_q) return held_q_;
  const double eta = stage_.held_stress_ratio;
  return eta * (next_cell_pa - seen[Quantity::pore_pressure]) / (1 - eta / 3);
}

double AxisControl::wanted_force(const Seen& seen, double next_cell_pa, double dt_s) const {
  switch (stage_.axial) {
    case AxialAction::load:
      return force_at_start_ + stage_.load_step_n +
             stage_.load_rate_n_per_s * (seen.stage_time_s() + dt_s);
    case AxialAction::constant_q:
    case AxialAction::stress_ratio:
      return wanted_stress(seen, next_cell_pa) * next_area_ + stage_.load_step_n;
    default:
      return force_at_start_;
  }
}

void AxisControl::follow_area(const Seen& seen, double next_cell_pa, AxisDemand& d) {
  d.area_m2 = seen.steady_area_m2();
  d.start_stress_pa = stress_;
  d.stress_pa = stress_ = wanted_stress(seen, next_cell_pa);
  d.force_n = stage_.load_step_n + trim_;
}

AxisDemand AxisControl::demand(const Seen& seen, double next_cell_pa, double dt_s) {
  AxisDemand d;
  const bool first = std::exchange(first_, false);
  if (stage_.axial == AxialAction::free) return d;
  if (!by_force(stage_.axial)) {
    d.kind = AxisDemand::Kind::crosshead;
    d.velocity_m_per_s = stage_.axial_rate_m_per_s;
    d.spring_n_per_m = stage_.spring_stiffness_n_per_m;
    return d;
  }
  d.kind = AxisDemand::Kind::force;
  d.dead = stage_.axial == AxialAction::dead_load;
  if (first) {
    d.impulse_n_s = stage_.impulse_n_s;
    d.perturbed = stage_.impulse_n_s != 0 || stage_.load_step_n != 0;
  }
  if (d.dead) {
    d.start_force_n = d.force_n = dead_force_;
    return d;
  }
  smooth_area(seen, dt_s);
  if (follows_area() && !first) wanted_ = stress_ * seen.steady_area_m2() + stage_.load_step_n;
  if (!first) trim_ += kTrim_per_s * dt_s * (*wanted_ - seen[Quantity::axial_force]);
  d.start_force_n = *wanted_ + trim_;
  wanted_ = wanted_force(seen, next_cell_pa, dt_s);
  d.force_n = *wanted_ + trim_;
  if (follows_area()) follow_area(seen, next_cell_pa, d);
  return d;
}

}  // namespace triax::lab
