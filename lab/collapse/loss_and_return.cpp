// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/loss_and_return.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/measured/assessment_limits.hpp"
#include "lab/measured/path_sampler.hpp"

namespace triax::lab {
namespace {

namespace limits = assessment_limits;

constexpr double kLeap = 1e-3;  ///< axial strain: less has no direction

}  // namespace

LossAndReturn::LossAndReturn(const State& before, double leap, Drainage drainage)
    : before_(std::fabs(before.q)),
      radial_(before.effective_stress.radial),
      least_(before_),
      most_(before_),
      sign_(std::copysign(1.0, std::fabs(leap) >= kLeap ? leap : before.q)),
      drainage_(drainage) {}

/// Towards where it was sheared when it ran.
double LossAndReturn::strength(const State& state) const { return sign_ * state.q; }

void LossAndReturn::start_stage(const StageInfo* stage) {
  stage_over_ = true;
  another_specimen_ = another_specimen_ || is_another_specimen(drainage_, stage);
}

void LossAndReturn::add(const State& state) {
  if (std::isnan(state.q)) return;
  if (drainage_ != Drainage::closed &&
      state.effective_stress.radial > limits::kConsolidated * radial_)
    another_specimen_ = true;
  if (another_specimen_) return;
  const double now = strength(state);
  noise_.add(now);
  const double both = std::min(now, std::exchange(last_, now));
  if (!stage_over_ && now < least_) least_ = most_ = std::max(now, 0.0);
  most_ = std::max(most_, both);
}

double LossAndReturn::lost() const { return before_ > 0 ? 1 - least_ / before_ : 0; }

double LossAndReturn::regained() const { return before_ > 0 ? (most_ - least_) / before_ : 0; }

bool LossAndReturn::came_back() const {
  return regained() >= std::max<double>(limits::kGrowth, limits::kReturn * lost()) &&
         most_ - least_ > limits::kNoise * noise_.value();
}

}  // namespace triax::lab
