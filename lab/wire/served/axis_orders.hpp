// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a loading frame on the wire was ordered to do, as demands on the plant tick by tick.
#include "lab/rig/demand.hpp"
#include "lab/wire/device_modes.hpp"

namespace triax::lab {

/// The set points of a frame, SI. A change of `mode` puts all of them into force at once.
struct FrameSettings {
  FrameMode mode = FrameMode::stop;
  double velocity_m_per_s = 0;  ///< crosshead
  double spring_n_per_m = 0;    ///< crosshead: of a spring between it and the cap; 0: none
  double force_from_n = 0;      ///< force, stress: at the start of the ramp
  double force_to_n = 0;        ///< at its end, from which on it holds; dead load: the load
  double force_time_s = 0;      ///< of the ramp
  double area_m2 = 0;           ///< stress: that to which the forces belong
  double stress_from_pa = 0, stress_to_pa = 0;  ///< stress: on the area as it changes
  double impulse_n_s = 0;                       ///< force, dead load: at the start
  bool perturbed = false;  ///< force, dead load: with inertia from the start on
};

/// Ramps run over the time of the plant from the instant at which they were ordered.
class AxisOrders {
 public:
  void order(const FrameSettings& settings, double time_s) {
    settings_ = settings;
    ordered_s_ = time_s;
    fresh_ = true;
  }
  const FrameSettings& settings() const { return settings_; }
  /// For the tick from `time_s` to dt later. A perturbation is of one tick.
  AxisDemand demand(double time_s, double dt_s);

 private:
  double ramp(double from, double to, double time_s) const;

  FrameSettings settings_;
  double ordered_s_ = 0;
  bool fresh_ = false;
};

}  // namespace triax::lab
