// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/backbone.hpp"

#include <algorithm>
#include <cmath>

#include "lab/measured/path_rates.hpp"

namespace triax::lab {
namespace {

constexpr double kStep = 1e-5;  ///< axial strain that is larger than before
constexpr double kLeap = 0.01;  ///< axial strain within which more than kGone of q went: no outlier
constexpr double kGone = 0.5;
constexpr double kTurn = 2e-4;      ///< axial strain back from the farthest: unloading, not noise
constexpr double kNearFront = 0.9;  ///< of the largest strain: it did not go back

PathStep step_between(const State& from, const State& to) {
  return {to.q - from.q, to.p_eff - from.p_eff, to.strain.axial - from.strain.axial,
          to.volumetric_strain - from.volumetric_strain};
}

}  // namespace

double BackboneFall::loss() const {
  return 1 - std::copysign(1.0, peak.q) * least.q / std::fabs(peak.q);
}

double BackboneFall::share_regained() const {
  const double lost = std::fabs(peak.q) - std::copysign(1.0, peak.q) * least.q;
  return lost > 0 ? (regained - std::copysign(1.0, peak.q) * least.q) / lost : 0;
}

double BackboneFall::normalised_work() const {
  return normalised_second_order_work(step_between(last_high, least));
}

void Backbone::Side::begin(const State& state) {
  worst = larger();
  fall =
      BackboneFall{.peak = state, .last_high = state, .least = state, .regained = strength(state)};
  any = true;
}

void Backbone::Side::descend(const State& state, bool drained) {
  const double now = strength(state), peak = strength(fall.peak);
  if (now >= kHigh * peak && fall.readings == 0) {
    fall.last_high = fall.least = state;
    return;
  }
  if (now < strength(fall.least)) {
    fall.least = state;
    fall.regained = now;
  }
  if (!(now < (1 - kWorth) * peak)) return;
  if (fall.readings > 0) {
    fall.confirmed = true;
    return;
  }
  fall.readings = state.reading - fall.last_high.reading;
  fall.confirmed = now < kGone * peak && sign * step_between(fall.last_high, state).axial > kLeap;
  fall.drained = drained;
}

bool Backbone::Side::counts() const {
  if (!any || fall.readings == 0) return false;
  const double lost = strength(fall.peak) - strength(fall.least);
  return strength(fall.peak) > kLeastRatio * fall.peak.p_eff && lost > kNoises * noise &&
         sign * (fall.least.strain.axial - fall.last_high.strain.axial) > kLeastStrain;
}

std::optional<BackboneFall> Backbone::Side::larger() const {
  if (!counts() || (worst && worst->loss() > fall.loss())) return worst;
  return fall;
}

void Backbone::Side::add(const State& state, double way, bool drained) {
  const bool onward = way > farthest + kStep;
  farthest = std::max(farthest, way);
  turned = turned || way < farthest - kTurn;
  const bool anew = !any || turned;
  if (onward) turned = false;
  if (onward && (anew || strength(state) > strength(fall.peak))) return begin(state);
  if (!any) return;
  if (onward) descend(state, drained);
  fall.regained = std::max(fall.regained, strength(state));
  // At the end of its travel the strain stands, and the strength is still gone.
  const bool gone = fall.readings > 0 && strength(state) < (1 - kWorth) * strength(fall.peak);
  if (!onward && gone && way > kNearFront * farthest) fall.confirmed = true;
}

/// Where q is smooth, however coarse, one bend follows another of its kind; noise bends to and fro.
void Backbone::learn_noise(double q) {
  const double bend = q_before_[1] - (q_before_[0] + q) / 2;
  const double noise =
      bend * bend_before_ < 0 ? std::min(std::fabs(bend), std::fabs(bend_before_)) : 0;
  if (++seen_ > 3)
    for (Side& side : sides_)
      if (side.fall.readings == 0) side.noise += (noise - side.noise) / ++side.noises;
  bend_before_ = seen_ > 2 ? bend : 0;
  q_before_ = {q_before_[1], q};
}

void Backbone::add(const State& state) {
  if (!origin_) origin_ = state.strain.axial;
  for (Side& side : sides_) side.add(state, side.sign * (state.strain.axial - *origin_), drained_);
  learn_noise(state.q);
}

std::optional<BackboneFall> Backbone::worst() const {
  std::optional<BackboneFall> worst;
  for (const Side& side : sides_)
    if (const auto one = side.larger(); one && (!worst || one->loss() > worst->loss())) worst = one;
  return worst;
}

}  // namespace triax::lab
