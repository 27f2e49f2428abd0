// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/second_order_work.hpp"

#include <fmt/format.h>

#include <utility>

#include "lab/measured/assessment_limits.hpp"
#include "lab/measured/instant.hpp"
#include "lab/measured/path_sampler.hpp"

namespace triax::lab {
namespace {

bool is_same(const std::optional<Descent>& a, const std::optional<Descent>& b) {
  return a && b && a->onset.reading == b->onset.reading;
}

std::string describe(const Descent& d) {
  const auto& w = d.evidence;
  return fmt::format(
      "normalised second-order work {:.3f} ± {:.3f} over {} readings; {:.0f} % of q lost while it "
      "was negative{}",
      w.work.normalised, w.normalised_error, w.window_readings, d.strength_loss() * 100,
      d.came_back ? ", then positive again" : "");
}

}  // namespace

Instant onset_of(const Descent& descent, bool has_time) {
  Instant at = instant_of(descent.best_onset(), has_time);
  at.interval = descent.interval;
  return at;
}

bool lasts_at_held_q(const Descent& descent) {
  return !descent.came_back &&
         descent.axial_strain_last - descent.onset.axial_strain >= assessment_limits::kHeldStrain;
}

void SecondOrderWork::start_stage(const StageInfo* stage) {
  held_q_ = stage && stage->control == AxialControl::constant_q;
  const Drainage before = std::exchange(drainage_, stage ? stage->drainage : Drainage::unknown);
  descents_.start_stage({.drained = is_drained_frame(stage),
                         .by_displacement = stage && stage->control == AxialControl::displacement,
                         .another_specimen = is_another_specimen(before, stage),
                         .closed = drainage_ == Drainage::closed && !held_q_,
                         .held_q = held_q_});
}

void SecondOrderWork::add_point(const PathPoint& point, bool has_time) {
  has_time_ = has_time;
  descents_.add(point);
  if (!latest()) return;
  if (latest_counts()) descents_.notice(now_);
  const bool yields = held_q_ && lasts_at_held_q(*latest());
  if (is_same(held_, latest()) || (yields && !held_)) held_ = latest();
}

bool SecondOrderWork::latest_counts() const {
  return latest() && (latest()->strength_loss() >= assessment_limits::kLossOfStrength ||
                      (held_q_ && lasts_at_held_q(*latest())));
}

const std::optional<Descent>& SecondOrderWork::at_held_q() const {
  return is_same(held_, latest()) ? latest() : held_;
}

std::optional<Finding> SecondOrderWork::finding() const {
  const auto& held = at_held_q();
  const auto& descent = held ? held : worst();
  if (!descent) return std::nullopt;
  return Finding{.instant = onset_of(*descent, has_time_),
                 .evidence = describe(*descent),
                 .detected = held || descent->strength_loss() >= assessment_limits::kLossOfStrength,
                 .noticed = descent->noticed};
}

}  // namespace triax::lab
