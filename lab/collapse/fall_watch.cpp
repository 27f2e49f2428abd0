// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/fall_watch.hpp"

#include <cmath>

#include "lab/measured/assessment_limits.hpp"
#include "lab/measured/path_sampler.hpp"

namespace triax::lab {

void FallWatch::start(const StageInfo* stage) {
  control_.start_stage(stage);
  holds_q_ = stage && stage->control == AxialControl::constant_q;
  readings_ = running_ = 0;
}

bool FallWatch::runs(const State& state) const {
  const State& before = *control_.before();
  const double leap = std::fabs(state.strain.axial - before.strain.axial);
  const double grown = LossOfControl::carried_load(state) / LossOfControl::carried_load(before) - 1;
  return leap >= assessment_limits::kRunaway && (holds_q_ || grown < leap / 2);
}

std::optional<Finding> FallWatch::watch(const State& state) {
  const StageInfo* stage = header_.stage(state.stage);
  if (!is_watched(stage) || std::isnan(state.strain.axial) || std::isnan(state.q)) return {};
  if (stage_ != state.stage) {
    if (!stage_) control_ = {};
    stage_ = state.stage;
    start(stage);
  }
  if (told_ == stage_) return {};
  control_.add_axis(state, header_.has_time);
  if (!control_.before()) {
    readings_ = running_ = 0;
    return {};
  }
  running_ = runs(state) ? running_ + 1 : 0;
  if (running_ == kInARow) {
    told_ = stage_;
    return control_.found();
  }
  if (++readings_ > kPatience) {
    control_ = {};
    start(stage);
  }
  return {};
}

}  // namespace triax::lab
