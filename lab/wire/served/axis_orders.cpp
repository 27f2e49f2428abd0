// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/served/axis_orders.hpp"

#include <utility>

namespace triax::lab {

double AxisOrders::ramp(double from, double to, double time_s) const {
  constexpr double kRoundOff_s = 1e-9;
  const double since = time_s - ordered_s_;
  if (since >= settings_.force_time_s - kRoundOff_s) return to;
  return from + (to - from) * since / settings_.force_time_s;
}

AxisDemand AxisOrders::demand(double time_s, double dt_s) {
  using enum FrameMode;
  const FrameSettings& s = settings_;
  const bool first = std::exchange(fresh_, false);
  AxisDemand d;
  if (s.mode == free) return d;
  if (s.mode == stop || s.mode == crosshead) {
    d.kind = AxisDemand::Kind::crosshead;
    if (s.mode == stop) return d;
    d.velocity_m_per_s = s.velocity_m_per_s;
    d.spring_n_per_m = s.spring_n_per_m;
    return d;
  }
  d.kind = AxisDemand::Kind::force;
  d.perturbed = first && s.perturbed;
  d.impulse_n_s = first ? s.impulse_n_s : 0;
  d.dead = s.mode == dead_load;
  d.start_force_n = d.dead ? s.force_to_n : ramp(s.force_from_n, s.force_to_n, time_s);
  d.force_n = d.dead ? s.force_to_n : ramp(s.force_from_n, s.force_to_n, time_s + dt_s);
  if (s.mode != stress) return d;
  d.area_m2 = s.area_m2;
  d.start_stress_pa = ramp(s.stress_from_pa, s.stress_to_pa, time_s);
  d.stress_pa = ramp(s.stress_from_pa, s.stress_to_pa, time_s + dt_s);
  return d;
}

}  // namespace triax::lab
