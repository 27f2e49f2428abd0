// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/drive_settings.hpp"

#include "lab/wire/device_modes.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::lab {
namespace {

PointSetting setting(const char* point, double si, double scale) {
  return {.point = point, .value = sim::to_field(si, {.name = {}, .scale = scale})};
}
PointSetting mode(FrameMode mode) { return {.point = "mode", .value = static_cast<double>(mode)}; }
PointSetting mode(ControllerMode mode) {
  return {.point = "mode", .value = static_cast<double>(mode)};
}

DriveSettings force_settings(const AxisDemand& d, double dt_s) {
  DriveSettings all{{.point = "force_to_N", .value = d.force_n},
                    {.point = "impulse_N_s", .value = d.impulse_n_s},
                    {.point = "perturbed", .value = d.perturbed ? 1.0 : 0.0}};
  if (d.dead) {
    all.push_back(mode(FrameMode::dead_load));
    return all;
  }
  all.push_back({.point = "force_from_N", .value = d.start_force_n});
  all.push_back({.point = "force_time_s", .value = dt_s});
  if (d.area_m2 > 0) {
    all.push_back(setting("area_mm2", d.area_m2, 1e-6));
    all.push_back(setting("stress_from_kPa", d.start_stress_pa, 1e3));
    all.push_back(setting("stress_to_kPa", d.stress_pa, 1e3));
  }
  all.push_back(mode(d.area_m2 > 0 ? FrameMode::stress : FrameMode::force));
  return all;
}

}  // namespace

DriveSettings stopped_frame() { return {mode(FrameMode::stop)}; }
DriveSettings held_pressure() { return {mode(ControllerMode::hold)}; }

DriveSettings frame_settings(const AxisDemand& demand, double dt_s) {
  using Kind = AxisDemand::Kind;
  if (demand.kind == Kind::free) return {mode(FrameMode::free)};
  if (demand.kind == Kind::force) return force_settings(demand, dt_s);
  if (demand.velocity_m_per_s == 0 && demand.spring_n_per_m == 0) return stopped_frame();
  return {setting("velocity_mm_per_min", demand.velocity_m_per_s, 1e-3 / 60),
          setting("spring_N_per_mm", demand.spring_n_per_m, 1e3), mode(FrameMode::crosshead)};
}

DriveSettings pressure_settings(const PressureDemand& demand) {
  if (demand.rate_pa_per_s == 0) return held_pressure();
  DriveSettings all{setting("rate_kPa_per_min", demand.rate_pa_per_s, 1e3 / 60)};
  if (demand.target_pa) all.push_back(setting("target_kPa", *demand.target_pa, 1e3));
  all.push_back(mode(demand.target_pa ? ControllerMode::ramp_to_target : ControllerMode::ramp));
  return all;
}

DriveSettings back_settings(const PlantDemand& demand) {
  DriveSettings all;
  if (demand.outflow_m3_per_s)
    all = {setting("flow_mm3_per_s", *demand.outflow_m3_per_s, 1e-9), mode(ControllerMode::flow)};
  else
    all = pressure_settings(demand.back);
  all.push_back({.point = "valve_open", .value = demand.valve_open ? 1.0 : 0.0});
  return all;
}

}  // namespace triax::lab
