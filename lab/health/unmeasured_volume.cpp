// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/unmeasured_volume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lab/health/sensor_limits.hpp"
#include "lab/measured/path_sampler.hpp"

namespace triax::lab {
UnmeasuredVolume::UnmeasuredVolume(const RecordHeader& header) : header_(header) {
  using enum Quantity;
  const auto has = [&](Quantity q) { return header.has(q); };
  has_volume_ = header.is_raw() ||
                std::ranges::any_of(
                    std::array{volumetric_strain, radial_strain, shear_strain, void_ratio}, has);
}

bool UnmeasuredVolume::is_unmeasured(const State& state) const {
  return !has_volume_ && is_watched(header_.stage(state.stage)) &&
         std::isnan(state.volumetric_strain) && std::isfinite(state.q) &&
         std::isfinite(state.p_eff) && std::isfinite(state.strain.axial);
}

State UnmeasuredVolume::completed(const State& state) {
  if (!is_unmeasured(state)) return state;
  if (stage_ != state.stage) radial_start_ = state.effective_stress.radial;
  stage_ = state.stage;
  const double change = std::fabs(state.effective_stress.radial - radial_start_);
  const bool is_constant =
      change <= std::max<double>(sensor_limits::kConstantStress * radial_start_,
                                 sensor_limits::kConstantStress_pa);
  if (!is_constant || !is_drained_frame(header_.stage(state.stage))) return state;
  State completed = state;
  completed.volumetric_strain = 0;
  completed.strain.radial = -completed.strain.axial / 2;
  return completed;
}

std::string UnmeasuredVolume::reason(const State& state) const {
  if (!is_unmeasured(state)) return {};
  if (!is_drained_frame(header_.stage(state.stage)))
    return "the record has no volumetric strain, which second-order work needs in a drained stage "
           "under a prescribed load or q";
  return fmt::format(
      "the record has no volumetric strain, which second-order work needs in a drained stage where "
      "σ₃′ is not constant (from {:.1f} kPa to {:.1f} kPa at reading {})",
      radial_start_ / 1e3, state.effective_stress.radial / 1e3, state.reading);
}

}  // namespace triax::lab
