// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/zero_stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/collapse/stress_span.hpp"
#include "lab/measured/assessment_limits.hpp"
#include "lab/measured/instant.hpp"

namespace triax::lab {
namespace {

constexpr double kStrainTolerance = 1e-4;  ///< noise of a displacement transducer
constexpr int kConfirmingReadings = 3;

Instant instant_between(const State& before, const State& first, const State& last, bool has_time) {
  Instant at = instant_of(first, has_time);
  StressSpan span(first.q, first.p_eff);
  span.reach(before.q, before.p_eff);
  span.reach(last.q, last.p_eff);
  at.interval = span.interval({});
  return at;
}

}  // namespace

void ZeroStress::start_stage(const StageInfo* stage) {
  ZeroStress next;
  next.finding_ = std::move(finding_);
  const AxialControl control = stage ? stage->control : AxialControl::unknown;
  next.is_searched_ = control == AxialControl::displacement || control == AxialControl::unknown;
  *this = std::move(next);
}

bool ZeroStress::is_gone(const State& state) const {
  const double strain = state.strain.axial;
  const bool goes_on = max_q_ < 0 ? strain <= min_strain_ + kStrainTolerance
                                  : strain >= max_strain_ - kStrainTolerance;
  const bool had_q = std::fabs(max_q_) >= assessment_limits::kZeroStressFrom * start_->p_eff;
  const bool no_q =
      had_q && std::fabs(state.q) <= assessment_limits::kZeroStress * std::fabs(max_q_);
  return goes_on && (no_q || state.p_eff <= assessment_limits::kZeroStress * start_->p_eff);
}

void ZeroStress::add_state(const State& state, bool has_time, const std::optional<Moment>& now) {
  if (!is_searched_ || finding_) return;
  if (!start_) {
    start_ = before_ = state;
    min_strain_ = max_strain_ = state.strain.axial;
  }
  min_strain_ = std::min(min_strain_, state.strain.axial);
  max_strain_ = std::max(max_strain_, state.strain.axial);
  if (std::fabs(state.q) > std::fabs(max_q_)) max_q_ = state.q;
  if (!is_gone(state)) {
    gone_count_ = 0;
    before_ = state;
    return;
  }
  if (gone_count_++ == 0) first_gone_ = state;
  if (gone_count_ < kConfirmingReadings) return;
  finding_ = Finding{
      .instant = instant_between(*before_, *first_gone_, state, has_time),
      .evidence = fmt::format(
          "q {:.2f} kPa, p' {:.2f} kPa: no stress left of q {:.2f} kPa, p' {:.2f} kPa",
          first_gone_->q / 1e3, first_gone_->p_eff / 1e3, max_q_ / 1e3, start_->p_eff / 1e3),
      .noticed = now};
}

}  // namespace triax::lab
