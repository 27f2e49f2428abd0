#pragma once
#include <optional>

namespace triax::lab {

/// A digital pressure/volume controller, as its pressure is driven: it ramps smoothly at the rate
/// asked for, within its own limits. What it reports is the business of its transducers.
struct PressureController {
  double range_pa = 0;  ///< highest pressure; the lowest is 0
  double rate_limit_pa_per_s = 0;
};

/// What a stage asks of it; without a rate it holds its pressure.
struct PressureDemand {
  double rate_pa_per_s = 0;         ///< of any sign
  std::optional<double> target_pa;  ///< where the ramp ends; reached exactly
};

/// Pressure dt later. Pre-condition: dt_s > 0.
double process(const PressureController& controller, double pressure_pa,
               const PressureDemand& demand, double dt_s);

}  // namespace triax::lab
