#include "lab/rig/plant.hpp"

#include <algorithm>

#include "lab/devices/force_cylinder.hpp"
#include "lab/records/reading.hpp"

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

sim::AxialDrive Plant::axis(const AxisDemand& demand, double cylinder_force_n, double dt_s,
                            const std::vector<Fault>& faults) const {
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
  const double velocity =
      holds(faults, FaultKind::stuck) ? 0 : given_velocity(frame_, demand.velocity_m_per_s);
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

const sim::SpecimenStep& Plant::advance(const PlantDemand& demand, double time_s, double dt_s) {
  const auto cell_faults = active_faults(faults_, "cell_controller", time_s);
  const auto back_faults = active_faults(faults_, "back_controller", time_s);
  const auto frame_faults = active_faults(faults_, "frame", time_s);
  const auto valve_faults = active_faults(faults_, "valve", time_s);
  PlantState next = state_;
  triax::lab::advance(cell_controller_, next.cell, demand.cell, cell_inflow_m3_, dt_s, cell_faults);

  sim::SpecimenBoundary boundary;
  boundary.cell_pressure_rate_pa_per_s =
      (next.cell.pressure_pa - state_.specimen.cell_pressure) / dt_s;
  const bool open = (demand.valve_open || holds(valve_faults, FaultKind::does_not_close)) &&
                    !holds(valve_faults, FaultKind::does_not_open);
  double outflow = demand.outflow_m3_per_s.value_or(0);
  if (demand.outflow_m3_per_s) {
    double pushed = -outflow;
    push(back_controller_, next.back, pushed, state_.specimen.pore_pressure, dt_s, back_faults);
    outflow = -pushed;
  } else {
    triax::lab::advance(back_controller_, next.back, demand.back, back_inflow_m3_, dt_s,
                        back_faults);
  }
  auto& water = boundary.water;
  if (open && demand.outflow_m3_per_s) {
    water.kind = sim::WaterDrive::Kind::flow;
    water.flow_m3_per_s = outflow;
  } else if (open) {
    water.kind = sim::WaterDrive::Kind::drained;
    water.back_pressure_pa = state_.back.pressure_pa;
    water.back_pressure_rate_pa_per_s = (next.back.pressure_pa - state_.back.pressure_pa) / dt_s;
  }

  const double force = specimen_.axial_force(state_.specimen);
  const bool follows_area = demand.axis.area_m2 > 0 && !holds(frame_faults, FaultKind::stuck);
  if (demand.axis.kind != AxisDemand::Kind::force) {
    next.cylinder_force_n = force;  // so that it takes over without a jump
  } else if (demand.axis.dead) {
    next.cylinder_force_n = demand.axis.force_n;
  } else if (!holds(frame_faults, FaultKind::stuck) && !follows_area) {
    ForceCylinderState cylinder{state_.cylinder_force_n};
    triax::lab::advance(frame_, cylinder, demand.axis.start_force_n, demand.axis.force_n, dt_s);
    next.cylinder_force_n = cylinder.force_n;
  }
  boundary.axis = axis(demand.axis, next.cylinder_force_n, dt_s, frame_faults);
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

double Plant::next_cell_pa(const PressureDemand& demand, double dt_s) const {
  ControllerState next = state_.cell;
  triax::lab::advance(cell_controller_, next, demand, 0, dt_s, {});
  return next.asked_pa;
}

double Plant::true_value(Quantity channel) const {
  const auto& s = state_.specimen;
  switch (channel) {
    case Quantity::axial_displacement: {
      const double load_cell = frame_.load_cell_stiffness_n_per_m;
      const double shortening = load_cell > 0 ? specimen_.axial_force(s) / load_cell : 0;
      return specimen_.start().height_m - s.height_m + shortening;
    }
    case Quantity::axial_force:
      return specimen_.axial_force(s);
    case Quantity::cell_pressure:
      return s.cell_pressure;
    case Quantity::back_pressure:
      return state_.back.pressure_pa;
    case Quantity::pore_pressure:
      return s.pore_pressure;
    case Quantity::back_volume:
      return given_volume(back_controller_, state_.back, back_inflow_m3_);
    case Quantity::cell_volume:
      return given_volume(cell_controller_, state_.cell, cell_inflow_m3_);
    default:
      return kMissing;
  }
}

}  // namespace triax::lab
