// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/end_condition.hpp"

#include <array>

namespace triax::lab {
namespace {

using enum EndQuantity;

constexpr auto kKeys = std::to_array<EndQuantityKey>({
    {"time_s", time, 1, 0, 1e7},
    {"time_min", time, 60, 0, 2e5},
    {"cell_pressure_kPa", cell_pressure, 1e3, 0, 1e5},
    {"back_pressure_kPa", back_pressure, 1e3, 0, 1e5},
    {"pore_pressure_kPa", pore_pressure, 1e3, -100, 1e5},
    {"pore_pressure_lag_kPa", pore_pressure_lag, 1e3, 0, 1e5},
    {"deviator_stress_kPa", deviator_stress, 1e3, -1e5, 1e5},
    {"q_kPa", deviator_stress, 1e3, -1e5, 1e5},
    {"mean_effective_stress_kPa", mean_effective_stress, 1e3, 0, 1e5},
    {"p_eff_kPa", mean_effective_stress, 1e3, 0, 1e5},
    {"stress_ratio", stress_ratio, 1, -1.5, 3},
    {"axial_strain_pct", axial_strain, 1e-2, -50, 50},
    {"volumetric_strain_pct", volumetric_strain, 1e-2, -50, 50},
    {"axial_displacement_mm", axial_displacement, 1e-3, -1e3, 1e3},
    {"axial_force_N", axial_force, 1, -1e6, 1e6},
    {"effective_axial_stress_kPa", effective_axial_stress, 1e3, -100, 1e5},
    {"effective_radial_stress_kPa", effective_radial_stress, 1e3, -100, 1e5},
    {"void_ratio", void_ratio, 1, 0, 20},
    {"back_volume_mm3", back_volume, 1e-9, -1e9, 1e9},
    {"volume_rate_mm3_per_min", volume_rate, 1e-9 / 60, 0, 1e9},
    {"axial_rate_mm_per_min", axial_rate, 1e-3 / 60, 0, 1e6},
    {"b_value", b_value, 1, 0, 1.5},
});

}  // namespace

std::span<const EndQuantityKey> end_quantity_keys() { return kKeys; }

}  // namespace triax::lab
