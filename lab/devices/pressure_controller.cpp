// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/pressure_controller.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/devices/first_order.hpp"

namespace triax::lab {
namespace {

/// Volumes that the piston can push out during a step; low <= 0 <= high.
struct Reach {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

Reach reach_of(const PressureController& c, const ControllerState& state, double dt_s,
               const std::vector<Fault>& active) {
  Reach reach;
  if (c.capacity_m3 > 0) {
    reach.low = std::min(0.0, state.held_volume_m3 - c.capacity_m3);
    reach.high = std::max(0.0, state.held_volume_m3);
  }
  if (c.volume_rate_limit_m3_per_s > 0 && c.fluid_compliance_m3_per_pa > 0) {
    reach.low = std::max(reach.low, -c.volume_rate_limit_m3_per_s * dt_s);
    reach.high = std::min(reach.high, c.volume_rate_limit_m3_per_s * dt_s);
  }
  const bool is_stuck = holds(active, FaultKind::stuck);
  if (is_stuck || holds(active, FaultKind::full)) reach.low = 0;
  if (is_stuck || holds(active, FaultKind::empty)) reach.high = 0;
  return reach;
}

double leak_of(const PressureController& c, const std::vector<Fault>& active) {
  double leak = c.leak_m3_per_s_per_pa;
  for (const Fault& fault : active)
    if (fault.kind == FaultKind::leak) leak += fault.size;
  return leak;
}

void move_piston(const PressureController& c, ControllerState& state, double given_m3,
                 const std::vector<Fault>& active) {
  constexpr double kRoundOff = 1e-12;
  state.given_volume_m3 += given_m3;
  state.held_volume_m3 -= given_m3;
  const double capacity = c.capacity_m3;
  state.full = holds(active, FaultKind::full) ||
               (capacity > 0 && state.held_volume_m3 >= capacity * (1 - kRoundOff));
  state.empty = holds(active, FaultKind::empty) ||
                (capacity > 0 && state.held_volume_m3 <= capacity * kRoundOff);
}

double set_point(const PressureController& c, double asked_pa) {
  const double step = c.pressure_resolution_pa;
  if (step == 0) return asked_pa;
  return std::min(std::round(asked_pa / step), std::floor(c.range_pa / step)) * step;
}

struct Course {
  double end_pa = 0, mean_pa = 0;
};

/// Pressure under the loop, whatever the piston has to do for it.
Course loop_course(const PressureController& c, double pressure_pa, double set_start_pa,
                   double set_end_pa, double inflow_m3, double leak, double dt_s) {
  const double tau = c.time_constant_s, compliance = c.fluid_compliance_m3_per_pa;
  if (tau == 0) return {set_end_pa, (pressure_pa + set_end_pa) / 2};
  double rate = 1 / tau, disturbance_pa_per_s = 0;
  if (compliance > 0) {
    rate += leak / compliance;
    disturbance_pa_per_s = inflow_m3 / dt_s / compliance;
  }
  const double drive_start = (set_start_pa / tau + disturbance_pa_per_s) / rate;
  const double drive_end = (set_end_pa / tau + disturbance_pa_per_s) / rate;
  const double end = first_order(pressure_pa, drive_start, drive_end, dt_s, 1 / rate);
  return {end, (drive_start + drive_end) / 2 - (end - pressure_pa) / (rate * dt_s)};
}

/// Pressure that the compliance makes of it when `added_m3` comes in, less what leaks.
double balance_pressure(const PressureController& c, double pressure_pa, double added_m3,
                        double leak, double dt_s) {
  const double compliance = c.fluid_compliance_m3_per_pa;
  if (compliance == 0) return pressure_pa;
  if (leak == 0) return pressure_pa + added_m3 / compliance;
  const double rest_pa = added_m3 / dt_s / leak;
  return first_order(pressure_pa, rest_pa, rest_pa, dt_s, compliance / leak);
}

}  // namespace

ControllerState at_rest(const PressureController& controller, double pressure_pa) {
  ControllerState state;
  state.pressure_pa = state.asked_pa = pressure_pa;
  state.held_volume_m3 = controller.start_volume_m3.value_or(controller.capacity_m3 / 2);
  return state;
}

double process(const PressureController& controller, double pressure_pa,
               const PressureDemand& demand, double dt_s) {
  const double limit = controller.rate_limit_pa_per_s;
  double next = pressure_pa + std::clamp(demand.rate_pa_per_s, -limit, limit) * dt_s;
  if (demand.target_pa && demand.rate_pa_per_s != 0) {
    const bool rising = demand.rate_pa_per_s > 0;
    const double target = *demand.target_pa;
    if (rising ? next > target : next < target)
      next = rising ? std::max(target, pressure_pa) : std::min(target, pressure_pa);
  }
  return std::clamp(next, 0.0, controller.range_pa);
}

void advance(const PressureController& controller, ControllerState& state,
             const PressureDemand& demand, double inflow_m3, double dt_s,
             const std::vector<Fault>& active) {
  const double asked_before = state.asked_pa;
  state.asked_pa = process(controller, asked_before, demand, dt_s);
  const double set_end = set_point(controller, state.asked_pa);
  const double set_start = controller.pressure_resolution_pa > 0 ? set_end : asked_before;
  const double leak = leak_of(controller, active);

  const Course course =
      loop_course(controller, state.pressure_pa, set_start, set_end, inflow_m3, leak, dt_s);
  const double stored = controller.fluid_compliance_m3_per_pa * (course.end_pa - state.pressure_pa);
  const double wanted = stored - inflow_m3 + leak * course.mean_pa * dt_s;
  const Reach reach = reach_of(controller, state, dt_s, active);
  const double given = std::clamp(wanted, reach.low, reach.high);
  double next = course.end_pa;
  if (given != wanted || holds(active, FaultKind::stuck))
    next = balance_pressure(controller, state.pressure_pa, inflow_m3 + given, leak, dt_s);
  state.pressure_pa = std::clamp(next, 0.0, controller.range_pa);
  move_piston(controller, state, given, active);
}

double possible_flow(const PressureController& controller, const ControllerState& state,
                     double flow_m3_per_s, double dt_s, const std::vector<Fault>& active) {
  const Reach reach = reach_of(controller, state, dt_s, active);
  const double leaking = leak_of(controller, active) * state.pressure_pa;
  return std::clamp(flow_m3_per_s + leaking, reach.low / dt_s, reach.high / dt_s) - leaking;
}

void push(const PressureController& controller, ControllerState& state, double& flow_m3_per_s,
          double answered_pressure_pa, double dt_s, const std::vector<Fault>& active) {
  const Reach reach = reach_of(controller, state, dt_s, active);
  flow_m3_per_s = possible_flow(controller, state, flow_m3_per_s, dt_s, active);
  const double mean_pa = (state.pressure_pa + answered_pressure_pa) / 2;
  const double stored =
      controller.fluid_compliance_m3_per_pa * (answered_pressure_pa - state.pressure_pa);
  const double wanted =
      flow_m3_per_s * dt_s + stored + leak_of(controller, active) * mean_pa * dt_s;
  state.pressure_pa = state.asked_pa = answered_pressure_pa;
  move_piston(controller, state, std::clamp(wanted, reach.low, reach.high), active);
}

}  // namespace triax::lab
