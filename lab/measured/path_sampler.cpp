// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/path_sampler.hpp"

#include <cmath>

namespace triax::lab {

bool is_watched(const StageInfo* stage) {
  return stage == nullptr || stage->role == StageRole::shear || stage->role == StageRole::unknown;
}

bool is_drained_frame(const StageInfo* stage) {
  return stage && stage->drainage == Drainage::open && stage->control != AxialControl::constant_q &&
         stage->control != AxialControl::load;
}

bool is_another_specimen(Drainage before, const StageInfo* stage) {
  const bool opened = before == Drainage::closed && stage && stage->drainage != Drainage::closed;
  return opened || !is_watched(stage);
}

std::optional<PathSample> PathSampler::sample(const State& s) {
  if (!std::isnan(last_strain_)) path_ += std::fabs(s.strain.axial - last_strain_);
  last_strain_ = s.strain.axial;
  has_pore_pressure_ = has_pore_pressure_ || std::isfinite(s.pore_pressure);
  if (has_pore_pressure_ && std::isnan(s.pore_pressure)) return std::nullopt;
  PathSample sample;
  sample.signal = {static_cast<double>(s.reading),
                   has_time_ ? s.time_s : path_,
                   s.q,
                   s.p_eff,
                   s.strain.axial,
                   s.volumetric_strain,
                   s.pore_pressure};
  return sample;
}

}  // namespace triax::lab
