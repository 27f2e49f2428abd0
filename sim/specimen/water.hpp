// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace triax::sim {

/// The water of specimen and lines as a function of the state, so that its balance closes over a
/// whole test and not only to first order:
///
///   M = V_w (1 + (u − u_start)/K_w) + C_system (u − u_start)
///
/// V_w is the water in the space between the grains and behind the membrane (pore_air.hpp), M a
/// volume as at u_start. M + what drained is constant; the increment of that is
/// V dε_v = C du − C_m dσ₃′ + Q dt.
class PoreWater {
 public:
  PoreWater() = default;
  /// 1/K_w (1/Pa), C_system (m³/Pa), u_start (Pa).
  PoreWater(double compressibility, double system_compliance, double start_pressure_pa)
      : compressibility_(compressibility),
        system_compliance_(system_compliance),
        start_pressure_pa_(start_pressure_pa) {}

  bool rigid() const { return compressibility_ == 0 && system_compliance_ == 0; }

  struct Content {
    double amount_m3 = 0;     ///< M
    double per_space = 1;     ///< ∂M/∂V of the space
    double compliance = 0;    ///< C = ∂M/∂u, m³/Pa
    double per_air = 0;       ///< ∂M/∂N, 1/Pa
    double dissolved_pa = 0;  ///< air that a volume of this water carries, Pa m³ per m³
  };
  Content content(double space_m3, double pore_pressure_pa, double air_pa_m3) const;

 private:
  double compressibility_ = 0, system_compliance_ = 0, start_pressure_pa_ = 0;
};

}  // namespace triax::sim
