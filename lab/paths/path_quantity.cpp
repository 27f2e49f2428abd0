// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/path_quantity.hpp"

namespace triax::lab {

const std::vector<PathQuantityKey>& path_quantity_keys() {
  using enum sim::PathQuantity;
  static const std::vector<PathQuantityKey> keys = {
      {"axial_strain", axial_strain, 0, 1, -2, 2},
      {"axial_strain_pct", axial_strain, 0, 1e-2, -200, 200},
      {"radial_strain", radial_strain, 0, 1, -2, 2},
      {"radial_strain_pct", radial_strain, 0, 1e-2, -200, 200},
      {"volumetric_strain", volumetric_strain, 0, 1, -2, 2},
      {"volumetric_strain_pct", volumetric_strain, 0, 1e-2, -200, 200},
      {"shear_strain", shear_strain, 0, 1, -2, 2},
      {"shear_strain_pct", shear_strain, 0, 1e-2, -200, 200},
      {"p_eff_kPa", mean_effective_stress, 0, 1e3, -1e5, 1e5},
      {"p_kPa", mean_total_stress, 0, 1e3, -1e5, 1e5},
      {"q_kPa", deviator_stress, 0, 1e3, -1e5, 1e5},
      {"eta", stress_ratio, 0, 1, -1.5, 3},
      {"stress_ratio", stress_ratio, 0, 1, -1.5, 3},
      {"axial_stress_kPa", axial_stress, 0, 1e3, -1e5, 1e5},
      {"radial_stress_kPa", radial_stress, 0, 1e3, -1e5, 1e5},
      {"effective_axial_stress_kPa", effective_axial_stress, 0, 1e3, -1e5, 1e5},
      {"effective_radial_stress_kPa", effective_radial_stress, 0, 1e3, -1e5, 1e5},
      {"pore_pressure_kPa", pore_pressure, 0, 1e3, -1e5, 1e5},
      {"void_ratio", void_ratio, 0, 1, 0, 20},
      {"strain_11", strain_component, 0, 1, -2, 2},
      {"strain_22", strain_component, 1, 1, -2, 2},
      {"strain_33", strain_component, 2, 1, -2, 2},
      {"strain_12", strain_component, 3, 1, -2, 2},
      {"strain_13", strain_component, 4, 1, -2, 2},
      {"strain_23", strain_component, 5, 1, -2, 2},
      {"stress_11_kPa", stress_component, 0, 1e3, -1e5, 1e5},
      {"stress_22_kPa", stress_component, 1, 1e3, -1e5, 1e5},
      {"stress_33_kPa", stress_component, 2, 1e3, -1e5, 1e5},
      {"stress_12_kPa", stress_component, 3, 1e3, -1e5, 1e5},
      {"stress_13_kPa", stress_component, 4, 1e3, -1e5, 1e5},
      {"stress_23_kPa", stress_component, 5, 1e3, -1e5, 1e5},
      {"effective_stress_11_kPa", effective_stress_component, 0, 1e3, -1e5, 1e5},
      {"effective_stress_22_kPa", effective_stress_component, 1, 1e3, -1e5, 1e5},
      {"effective_stress_33_kPa", effective_stress_component, 2, 1e3, -1e5, 1e5},
  };
  return keys;
}

}  // namespace triax::lab
