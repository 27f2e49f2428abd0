#include "lab/rig/strain_path_control.hpp"

#include <cmath>

namespace triax::lab {

double StrainPathControl::height_m(const Seen& seen) const {
  return built_height_m_ - seen[Quantity::axial_displacement];
}

void StrainPathControl::begin_stage(const Stage& stage, const Seen& seen) {
  R_ = stage.strain_path_R;
  axial_rate_m_per_s_ = stage.axial_rate_m_per_s;
  start_height_m_ = height_m(seen);
  start_volume_m3_ = seen.state().area_m2 * start_height_m_;
  start_back_volume_m3_ = seen[Quantity::back_volume];
}

std::optional<double> StrainPathControl::outflow_m3_per_s(const Seen& seen, double dt_s) const {
  if (!R_) return std::nullopt;
  const double height = height_m(seen) - axial_rate_m_per_s_ * dt_s;
  const double wanted = start_volume_m3_ * std::pow(height / start_height_m_, 1 - 1 / *R_);
  const double volume = start_volume_m3_ + seen[Quantity::back_volume] - start_back_volume_m3_;
  return (volume - wanted) / dt_s;
}

}  // namespace triax::lab
