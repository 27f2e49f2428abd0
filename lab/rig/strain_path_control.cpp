// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/strain_path_control.hpp"

#include <cmath>

namespace triax::lab {

double StrainPathControl::height_m(const Seen& seen) const {
  return built_height_m_ - seen[Quantity::axial_displacement];
}

double StrainPathControl::wanted_m3(double height_m) const {
  return start_volume_m3_ * std::pow(height_m / start_height_m_, 1 - 1 / *R_);
}

void StrainPathControl::begin_stage(const Stage& stage, const Seen& seen) {
  R_ = stage.strain_path_R;
  axial_rate_m_per_s_ = stage.axial_rate_m_per_s;
  start_height_m_ = height_m(seen);
  start_volume_m3_ = seen.state().area_m2 * start_height_m_;
  start_back_volume_m3_ = seen[Quantity::back_volume];
  height_.start(start_height_m_, -axial_rate_m_per_s_);
}

std::optional<double> StrainPathControl::outflow_m3_per_s(const Seen& seen, double dt_s) {
  if (!R_) return std::nullopt;
  const double volume = start_volume_m3_ + seen[Quantity::back_volume] - start_back_volume_m3_;
  if (!height_.active())
    return (volume - wanted_m3(height_m(seen) - axial_rate_m_per_s_ * dt_s)) / dt_s;
  height_.take(height_m(seen), dt_s);
  const double now = wanted_m3(height_.level());
  return (now - wanted_m3(height_.expected(dt_s))) / dt_s +
         (volume - now) / height_.time_constant_s();
}

}  // namespace triax::lab
