// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <vector>

#include "lab/devices/fault.hpp"

namespace triax::lab {

/// A digital pressure/volume controller (DPVC): a cylinder of water, a piston and a pressure loop.
/// Water is positive that flows into the cylinder through its port (inflow) and that the piston
/// pushes (given). Its water and tubing of compliance C, its loop of time constant τ, and a leak of
/// flow L p:
///   C ṗ = inflow rate + piston's rate − L p,    the piston so that ṗ = (set − p)/τ + (inflow − L
///   p)/C
/// With C = 0 no flow disturbs the pressure; with τ = 0 it is the set point. An imperfection of 0
/// is absent. What it reports is the business of its transducers.
struct PressureController {
  double range_pa = 0;  ///< highest pressure; the lowest is 0
  double rate_limit_pa_per_s = 0;
  double pressure_resolution_pa = 0;      ///< set points are whole steps of it
  double time_constant_s = 0;             ///< τ
  double fluid_compliance_m3_per_pa = 0;  ///< C
  double capacity_m3 = 0;                 ///< of the cylinder; 0: unlimited
  std::optional<double> start_volume_m3;  ///< water in it at the start; without: half full
  double volume_rate_limit_m3_per_s = 0;  ///< of the piston; 0: unlimited. Needs C > 0
  double leak_m3_per_s_per_pa = 0;        ///< L
};

/// What a stage asks of it; without a rate it holds its pressure.
struct PressureDemand {
  double rate_pa_per_s = 0;         ///< of any sign
  std::optional<double> target_pa;  ///< where the ramp ends; reached exactly
};

struct ControllerState {
  double pressure_pa = 0;      ///< at its port, true
  double asked_pa = 0;         ///< where the ramp is; rounded to the resolution: the set point
  double held_volume_m3 = 0;   ///< room behind the port; below 0 only where capacity is unlimited
  double given_volume_m3 = 0;  ///< that the piston pushed out since the start: what it reports
  bool full = false;           ///< the piston is at its end, or a fault says so
  bool empty = false;
  bool operator==(const ControllerState&) const = default;
};

/// At rest at that pressure.
ControllerState at_rest(const PressureController& controller, double pressure_pa);

/// Where a ramp is dt later, within the limits of rate and range. Pre-condition: dt_s > 0.
double process(const PressureController& controller, double pressure_pa,
               const PressureDemand& demand, double dt_s);

/// Pressure control for dt; `inflow_m3` came in during it, at a constant rate. Set points ramp
/// linearly (a rounded one stands at its end value). A piston that cannot do what the loop wants —
/// at its end, at its fastest, stuck — does what it can, and the pressure is what the compliance
/// makes of it; with C = 0 it stays as it is. Below 0 the cylinder draws air, above the range a
/// relief valve opens: the pressure stays at that limit. `active`: this controller's faults.
/// Pre-condition: dt_s > 0.
void advance(const PressureController& controller, ControllerState& state,
             const PressureDemand& demand, double inflow_m3, double dt_s,
             const std::vector<Fault>& active = {});

/// The flow out of its port, as near to `flow_m3_per_s` as the piston can give it for dt.
double possible_flow(const PressureController& controller, const ControllerState& state,
                     double flow_m3_per_s, double dt_s, const std::vector<Fault>& active = {});

/// Volume control for dt: `flow_m3_per_s` out of the port is cut to what is possible, and the
/// pressure is what the other side answered. What its own water swallows and what leaks the piston
/// pushes in addition. Pressure control goes on from that pressure.
void push(const PressureController& controller, ControllerState& state, double& flow_m3_per_s,
          double answered_pressure_pa, double dt_s, const std::vector<Fault>& active = {});

}  // namespace triax::lab
