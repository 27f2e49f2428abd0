// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/pore_air.hpp"

#include <algorithm>

namespace triax::sim {

AirySpace airy_space(double space_m3, double pore_pressure_pa, double air_pa_m3) {
  AirySpace found{space_m3, 1, 0, 0, 0};
  if (!(air_pa_m3 > 0)) return found;
  const double p = std::max(pore_pressure_pa + kAtmosphere_pa, 0.01 * kAtmosphere_pa);
  const double h = kAirSolubility;
  if (air_pa_m3 <= h * p * space_m3) {
    found.dissolved_pa = air_pa_m3 / space_m3;
    return found;
  }
  found.water_m3 = (space_m3 - air_pa_m3 / p) / (1 - h);
  found.water_slope = 1 / (1 - h);
  found.compliance = air_pa_m3 / (p * p) / (1 - h);
  found.air_displaces = 1 / (p * (1 - h));
  found.dissolved_pa = h * p;
  return found;
}

double amount_of_air(double space_m3, double saturation, double pore_pressure_pa) {
  if (saturation >= 1) return 0;
  return (pore_pressure_pa + kAtmosphere_pa) * space_m3 * (1 - saturation * (1 - kAirSolubility));
}

double dissolving_pressure_pa(double saturation, double pore_pressure_pa) {
  if (saturation >= 1) return pore_pressure_pa;
  const double h = kAirSolubility;
  return (pore_pressure_pa + kAtmosphere_pa) * (1 - saturation * (1 - h)) / (saturation * h) -
         kAtmosphere_pa;
}

}  // namespace triax::sim
