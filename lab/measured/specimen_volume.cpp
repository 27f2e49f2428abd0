// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/specimen_volume.hpp"

#include <cmath>
#include <numbers>

#include "lab/measured/path_sampler.hpp"

namespace triax::lab {

SpecimenVolume::SpecimenVolume(const SpecimenInfo& specimen) {
  if (specimen.height_m && specimen.diameter_m)
    volume_m3_ =
        std::numbers::pi / 4 * *specimen.diameter_m * *specimen.diameter_m * *specimen.height_m;
}

State SpecimenVolume::with_fluid(const State& state, const StageInfo* stage) {
  if (!is_watched(stage)) {
    compliance_.reset();
    fluid_.add(state, stage);
    return state;
  }
  if (!std::isfinite(state.pore_pressure)) return state;
  if (!compliance_) {
    compliance_ = fluid_.posterior(state.pore_pressure, volume_m3_);
    at_start_ = compliance_->strain(state.pore_pressure);
  }
  State with = state;
  with.volumetric_strain += compliance_->strain(state.pore_pressure) - at_start_;
  return with;
}

}  // namespace triax::lab
