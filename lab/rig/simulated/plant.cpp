// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/simulated/plant.hpp"

#include <algorithm>

#include "lab/devices/force_cylinder.hpp"
#include "lab/results/reading.hpp"

namespace triax::lab {
namespace {

constexpr double kGravity = 9.80665;  // m/s²

/// Stiffness of springs in series; 0 stands for a rigid one.
double in_series(double a, double b) {
  if (a == 0) return b;
  return b == 0 ? a : a * b / (a + b);
}

/// A controller without compliance of its own gives way to an inflow at once, within the same tick.
double given_volume(const PressureController& controller, const ControllerState& state,
                    double inflow_m3) {
  return state.given_volume_m3 - (controller.fluid_compliance_m3_per_pa == 0 ? inflow_m3 : 0);
}

}  // namespace

Plant::Plant(const Programme& p)
    : faults_(p.faults),
      cell_controller_(p.cell_controller),
      back_controller_(p.back_controller),
      frame_(p.frame),
      specimen_(p.material.material.axisymmetric, p.specimen, p.void_ratio,
                p.initial_effective_stress_pa, p.initial_back_pressure_pa) {
  state_.specimen = specimen_.start();
  state_.cell = at_rest(cell_controller_, state_.specimen.cell_pressure);
  state_.back = at_rest(back_controller_, p.initial_back_pressure_pa);
}

sim::AxialDrive Plant::axis(const AxisDemand& demand, double cylinder_force_n, bool stuck,
                            double dt_s) const {
  using Kind = sim::AxialDrive::Kind;
  sim::AxialDrive drive;
  drive.mass_kg = frame_.moving_mass_kg;
  drive.damping_n_s_per_m = frame_.damping_n_s_per_m;
  drive.travel_m = frame_.travel_m;
  if (demand.kind == AxisDemand::Kind::free) return drive;
  if (demand.kind == AxisDemand::Kind::force) {
    drive.kind = Kind::force;
    const double before = demand.dead ? cylinder_force_n : state_.cylinder_force_n;
    drive.force_n = before;
    drive.force_rate_n_per_s = (cylinder_force_n - before) / dt_s;
    drive.inertial = demand.perturbed;
    drive.impulse_n_s = demand.impulse_n_s;
    if (demand.dead) drive.mass_kg += std::max(0.0, cylinder_force_n) / kGravity;
    return drive;
  }
  const double velocity = stuck ? 0 : given_velocity(frame_, demand.velocity_m_per_s);
  const double stiffness =
      in_series(in_series(frame_.stiffness_n_per_m, frame_.load_cell_stiffness_n_per_m),
                demand.spring_n_per_m);
  drive.kind = stiffness > 0 ? Kind::force : Kind::rigid;
  drive.velocity_m_per_s = velocity;
  // A cap in motion is not in equilibrium: the spring still holds what it held.
  const sim::SpecimenState& now = state_.specimen;
  drive.force_n = now.run_away.under_way ? now.applied_force_n : specimen_.axial_force(now);
  drive.force_rate_n_per_s = stiffness * velocity;
  drive.stiffness_n_per_m = stiffness;
  return drive;
}

void Plant::follow_area(const AxisDemand& demand, double dt_s, sim::AxialDrive& drive) const {
  const double area = specimen_.area_m2(state_.specimen);
  const double at_end = demand.force_n + demand.stress_pa * (demand.area_m2 - area);
  drive.force_n = state_.cylinder_force_n - demand.start_stress_pa * area;
  drive.force_rate_n_per_s = (at_end - drive.force_n) / dt_s;
  drive.stress_pa = demand.start_stress_pa;
  drive.stress_rate_pa_per_s = (demand.stress_pa - demand.start_stress_pa) / dt_s;
}

/// Moves the back controller on; what that is to the specimen's water.
sim::WaterDrive Plant::water(const PlantDemand& demand, double time_s, double dt_s,
                             ControllerState& back) const {
  const auto faults = active_faults(faults_, "back_controller", time_s);
  const auto valve_faults = active_faults(faults_, "valve", time_s);
  double pushed = -demand.outflow_m3_per_s.value_or(0);
  if (demand.outflow_m3_per_s)
    push(back_controller_, back, pushed, state_.specimen.pore_pressure, dt_s, faults);
  else
    triax::lab::advance(back_controller_, back, demand.back, back_inflow_m3_, dt_s, faults);
  sim::WaterDrive water;
  const bool open = (demand.valve_open || holds(valve_faults, FaultKind::does_not_close)) &&
                    !holds(valve_faults, FaultKind::does_not_open);
  if (!open) return water;
  if (demand.outflow_m3_per_s) {
    water.kind = sim::WaterDrive::Kind::flow;
    water.flow_m3_per_s = -pushed;
  } else {
    water.kind = sim::WaterDrive::Kind::drained;
    water.back_pressure_pa = state_.back.pressure_pa;
    water.back_pressure_rate_pa_per_s = (back.pressure_pa - state_.back.pressure_pa) / dt_s;
  }
  return water;
}

/// The cylinder's force at the end of the tick. Where it moves nothing it stands ready at the
/// specimen's, so that it takes over without a jump.
double Plant::next_cylinder_force_n(const AxisDemand& demand, bool stuck, double dt_s) const {
  if (demand.kind != AxisDemand::Kind::force) return specimen_.axial_force(state_.specimen);
  if (demand.dead) return demand.force_n;
  ForceCylinderState cylinder{state_.cylinder_force_n};
  if (!stuck && demand.area_m2 == 0)
    triax::lab::advance(frame_, cylinder, demand.start_force_n, demand.force_n, dt_s);
  return cylinder.force_n;
}

const sim::SpecimenStep& Plant::advance(const PlantDemand& demand, double time_s, double dt_s) {
  const auto cell_faults = active_faults(faults_, "cell_controller", time_s);
  const auto frame_faults = active_faults(faults_, "frame", time_s);
  const bool stuck = holds(frame_faults, FaultKind::stuck);
  PlantState next = state_;
  triax::lab::advance(cell_controller_, next.cell, demand.cell, cell_inflow_m3_, dt_s, cell_faults);
  next.cylinder_force_n = next_cylinder_force_n(demand.axis, stuck, dt_s);

  sim::SpecimenBoundary boundary;
  boundary.cell_pressure_rate_pa_per_s =
      (next.cell.pressure_pa - state_.specimen.cell_pressure) / dt_s;
  boundary.water = water(demand, time_s, dt_s, next.back);
  boundary.axis = axis(demand.axis, next.cylinder_force_n, stuck, dt_s);
  const bool follows_area = demand.axis.area_m2 > 0 && !stuck;
  if (follows_area) follow_area(demand.axis, dt_s, boundary.axis);

  step_ = specimen_.advance(state_.specimen, boundary, dt_s);
  if (step_.outcome == sim::StepOutcome::failed || step_.outcome == sim::StepOutcome::lost_control)
    return step_;
  next.specimen = step_.state;
  next.specimen.cell_pressure = next.cell.pressure_pa;
  const double before = specimen_.volume_m3(state_.specimen);
  cell_inflow_m3_ = specimen_.volume_m3(step_.state) - before;
  back_inflow_m3_ = demand.outflow_m3_per_s
                        ? 0
                        : step_.state.drained_volume_m3 - state_.specimen.drained_volume_m3;
  if (demand.axis.kind != AxisDemand::Kind::force || follows_area)
    next.cylinder_force_n = specimen_.axial_force(next.specimen);
  state_ = std::move(next);
  return step_;
}

double Plant::true_value(Quantity channel) const {
  const auto& s = state_.specimen;
  if (const auto of_specimen = info(channel).raw.of_specimen)
    return of_specimen(s, specimen_.start());
  switch (channel) {
    case Quantity::axial_displacement: {
      const double load_cell = frame_.load_cell_stiffness_n_per_m;
      const double shortening = load_cell > 0 ? specimen_.axial_force(s) / load_cell : 0;
      return specimen_.start().height_m - s.height_m + shortening;
    }
    case Quantity::axial_force:
      return specimen_.axial_force(s);
    case Quantity::back_pressure:
      return state_.back.pressure_pa;
    case Quantity::back_volume:
      return given_volume(back_controller_, state_.back, back_inflow_m3_);
    case Quantity::cell_volume:
      return given_volume(cell_controller_, state_.cell, cell_inflow_m3_);
    default:
      return kMissing;
  }
}

Programme as_far_as_simulated(Programme programme) {
  for (const auto& row : raw_channels())
    if (!row.raw.standard && row.raw.of_specimen == nullptr)
      programme.fitted[index(row.quantity)] = false;
  return programme;
}

}  // namespace triax::lab
