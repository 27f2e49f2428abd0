// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/undrained_strength.hpp"

#include <cmath>

#include "lab/measured/instant.hpp"

namespace triax::lab {

void UndrainedStrengthFinder::add(const State& state) {
  const double strain = std::fabs(state.strain.axial);
  if (std::isnan(state.q) || std::isnan(strain)) return;
  peak_.add(state);
  if (strain <= kIsoFailureStrain) up_to_iso_strain_.add(state);
  if (!at_astm_strain_ && strain >= kAstmFailureStrain) at_astm_strain_ = state;
  last_strain_ = strain;
  last_q_ = state.q;
}

std::optional<UndrainedStrength> UndrainedStrengthFinder::result(bool has_time) const {
  const auto& failure = up_to_iso_strain_.state();
  if (!failure) return std::nullopt;
  UndrainedStrength found{.at = instant_of(*failure, has_time),
                          .at_15_pct = {},
                          .last_axial_strain = last_strain_,
                          .peaked = peak_.state()->reading == failure->reading &&
                                    std::fabs(last_q_) < std::fabs(failure->q)};
  if (at_astm_strain_ && std::fabs(failure->strain.axial) > kAstmFailureStrain)
    found.at_15_pct = instant_of(*at_astm_strain_, has_time);
  return found;
}

}  // namespace triax::lab
