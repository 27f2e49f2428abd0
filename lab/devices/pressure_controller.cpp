#include "lab/devices/pressure_controller.hpp"

#include <algorithm>

namespace triax::lab {

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

}  // namespace triax::lab
