// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/rig_header.hpp"

#include <fmt/format.h>

#include "sim/mechanics/axisymmetric.hpp"

namespace triax::lab {
namespace {

template <class Number>
std::optional<Number> unless_zero(Number value) {
  return value == 0 ? std::nullopt : std::optional(value);
}

}  // namespace

RecordHeader rig_header(const Programme& programme, std::uint64_t seed) {
  RecordHeader h;
  h.name = programme.name;
  h.origin = Origin::simulated;
  h.programme = programme.type;
  h.source = programme.source;
  h.seed = seed;
  h.specimen.height_m = programme.specimen.height_m;
  h.specimen.diameter_m = programme.specimen.diameter_m;
  h.specimen.void_ratio = programme.void_ratio;
  h.specimen.specific_gravity = programme.specific_gravity;
  h.specimen.membrane_thickness_m = unless_zero(programme.specimen.membrane_thickness_m);
  h.specimen.membrane_modulus_pa = unless_zero(programme.specimen.membrane_young_modulus_pa);
  h.specimen.material = programme.material.name;
  if (const auto limit = programme.material.material.axisymmetric->limit_stress_ratio())
    h.specimen.limit_friction_angle_rad = sim::mobilised_friction_angle(*limit);
  else
    h.specimen.limit_friction_angle_rad = programme.limit_friction_angle_rad;
  int number = 1;
  for (const Stage& stage : programme.stages)
    h.stages.push_back({.number = number++,
                        .name = stage.name,
                        .role = stage.role,
                        .drainage = stage.valve_open ? Drainage::open : Drainage::closed,
                        .control = way_of(stage.axial).control,
                        .strain_path_R = stage.strain_path_R});
  h.stages.push_back({.number = number,
                      .name = "held",
                      .role = StageRole::hold,
                      .drainage = Drainage::unknown,
                      .control = AxialControl::displacement,
                      .strain_path_R = {}});
  for (const auto& row : raw_channels())
    if (programme.fitted[index(row.quantity)]) h.columns.push_back(row.quantity);
  for (const TomlEdit& change : programme.changes)
    h.warnings.push_back(
        {0, fmt::format("{} = {} from --set, instead of the value of the programme", change.key,
                        change.value)});
  for (const Fault& fault : programme.faults) h.warnings.push_back({0, describe(fault)});
  return h;
}

}  // namespace triax::lab
