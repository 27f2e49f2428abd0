// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/water.hpp"

#include "sim/specimen/pore_air.hpp"

namespace triax::sim {

PoreWater::Content PoreWater::content(double space_m3, double pore_pressure_pa,
                                      double air_pa_m3) const {
  const AirySpace space = airy_space(space_m3, pore_pressure_pa, air_pa_m3);
  const double risen = pore_pressure_pa - start_pressure_pa_;
  const double density = 1 + risen * compressibility_;
  return {space.water_m3 * density + system_compliance_ * risen, space.water_slope * density,
          space.compliance * density + space.water_m3 * compressibility_ + system_compliance_,
          -space.air_displaces * density, space.dissolved_pa};
}

}  // namespace triax::sim
