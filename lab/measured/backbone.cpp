// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/backbone.hpp"

#include <algorithm>
#include <cmath>

#include "lab/measured/assessment_limits.hpp"
#include "lab/measured/path_rates.hpp"

namespace triax::lab {
namespace {

constexpr double kStep = 1e-5;  ///< axial strain that is larger than before
constexpr double kTurn = 2e-4;  ///< back from the farthest: unloading, not noise
namespace limits = assessment_limits;
constexpr double kLeapOfSteps = 3;  ///< times the largest step of the strain before

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

/// What was strongest longer ago than kFew readings is for windows to compare with.
void Backbone::Side::forget(const State& state) {
  while (!recent.empty() && recent.front().reading < state.reading - kFew) recent.pop_front();
  if (fall.readings > 0 || recent.empty() || fall.peak.reading >= recent.front().reading) return;
  const auto by_strength = [this](const State& s) { return strength(s); };
  const auto peak = std::ranges::max_element(recent, {}, by_strength);
  fall.peak = *peak;
  fall.before_peak = peak == recent.begin() ? *peak : *(peak - 1);
  for (const State& s : recent)
    if (strength(s) >= limits::kNearPeak * strength(fall.peak)) fall.last_high = fall.least = s;
  fall.regained = strength(fall.least);
  fall.noise = noise.value();
}

void Backbone::Side::begin(const State& state) {
  if (fall.confirmed) worst = larger();
  fall = BackboneFall{.before_peak = recent.empty() ? state : recent.back(),
                      .peak = state,
                      .last_high = state,
                      .least = state,
                      .regained = strength(state),
                      .noise = noise.value()};
  any = true;
}

bool Backbone::Side::gone(const State& state) const {
  return strength(state) <
         (1 - limits::kLossOfStrength) * strength(fall.peak) - limits::kNoise * fall.noise;
}

/// The strength is gone at this state. A single one may be an outlier: it shows no pace.
void Backbone::Side::note_low(const State& state) {
  const double advance = strain(state) - strain(fall.last_high);
  const auto readings = static_cast<double>(state.reading - fall.last_high.reading);
  fall.axis_went_on =
      fall.axis_went_on || advance > kMinStrain ||
      (fall.first_low.reading < state.reading && pace > 0 && advance >= kMinPace * pace * readings);
}

/// Of the readings before the fall; 0 if they are too few to know their noise.
double Backbone::Side::pace_of_recent() const {
  const std::int64_t readings =
      recent.empty() ? 0 : fall.last_high.reading - recent.front().reading;
  if (readings < kFew / 2) return 0;
  return (strain(fall.last_high) - strain(recent.front())) / static_cast<double>(readings);
}

void Backbone::Side::descend(const State& state, double step, bool drained) {
  const double now = strength(state), peak = strength(fall.peak);
  if (fall.readings == 0 && now >= limits::kNearPeak * peak) {
    fall.last_high = fall.least = state;
    fall.noise = noise.value();
    return;
  }
  if (now < strength(fall.least)) {
    fall.least = state;
    fall.regained = now;
  }
  if (fall.readings > 0 && gone(state)) note_low(state);
  if (fall.confirmed) return;
  if (!gone(state)) {
    fall.readings = 0;  // one state alone was an outlier
    fall.axis_went_on = false;
    return;
  }
  if (fall.readings > 0) {
    fall.confirmed = true;
    return;
  }
  fall.readings = state.reading - fall.last_high.reading;
  fall.first_low = state;
  pace = pace_of_recent();
  note_low(state);
  fall.drained = drained;
  fall.confirmed = now < limits::kLeapLoss * peak &&
                   step > std::max<double>(limits::kLeap, kLeapOfSteps * largest_step);
}

bool Backbone::Side::counts() const {
  return any && fall.readings > 0 && fall.readings <= kFew &&
         strength(fall.peak) > limits::kMinRatio * fall.peak.p_eff && gone(fall.least) &&
         fall.axis_went_on && fall.normalised_work() < 0;
}

std::optional<BackboneFall> Backbone::Side::larger() const {
  if (!counts() || (worst && worst->loss() > fall.loss())) return worst;
  return fall;
}

void Backbone::Side::add(const State& state, double way, bool drained) {
  const bool onward = !any || way > farthest + kStep;
  const double step = way - farthest;
  front = std::max(front, way);
  turned = turned || way < front - kTurn;
  if (worst) worst->regained = std::max(worst->regained, strength(state));
  if (!onward) {
    // At the end of its travel the strain stands, and the strength is still gone.
    if (fall.readings > 0 && gone(state) && !turned) {
      fall.confirmed = true;
      note_low(state);
    }
    fall.regained = std::max(fall.regained, strength(state));
    return;
  }
  farthest = way;
  // One state behind: the last before an unloading may be of the loop, which bends as noise does.
  if (turned)
    noise.interrupt();
  else if (!recent.empty())
    noise.add(strength(recent.back()));
  forget(state);
  if (!any || turned || strength(state) > strength(fall.peak)) {
    if (turned) recent.clear();
    turned = false;
    begin(state);
  } else {
    descend(state, step, drained);
    fall.regained = std::max(fall.regained, strength(state));
  }
  largest_step = std::max(largest_step, step);
  recent.push_back(state);
}

void Backbone::start_stage(bool drained) {
  drained_ = drained;
  new_stage_ = true;
}

void Backbone::add(const State& state, const std::optional<Moment>& now) {
  if (!first_) first_ = state;
  // The next specimen of a multistage test is stronger from its first reading on.
  if (new_stage_ && last_ && state.p_eff > limits::kConsolidated * last_->p_eff)
    for (Side& side : sides_) side.turned = true;
  new_stage_ = false;
  last_ = state;
  for (Side& side : sides_) {
    side.add(state, side.sign * (state.strain.axial - first_->strain.axial), drained_);
    if (side.fall.confirmed && !side.fall.noticed) side.fall.noticed = now;
  }
}

std::optional<BackboneFall> Backbone::worst() const {
  std::optional<BackboneFall> worst;
  for (const Side& side : sides_)
    if (const auto one = side.larger(); one && (!worst || one->loss() > worst->loss())) worst = one;
  return worst;
}

}  // namespace triax::lab
