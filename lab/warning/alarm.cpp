// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/alarm.hpp"

#include <cmath>

#include "lab/base/listeners.hpp"
#include "lab/warning/warning_words.hpp"

namespace triax::lab {
Alarm::Alarm(const RecordHeader& header, AlarmListeners listeners)
    : header_(header),
      listeners_(std::move(listeners)),
      sampler_(header.has_time),
      limit_(header.specimen),
      levels_(header.has_time) {
  rates_.on_point = [this](const PathPoint& point) { take(point); };
}

void Alarm::start_stage(const State& state) {
  take_back(state, "its stage ended");
  rates_.finish();
  rest_.finish();
  const StageInfo* info = header_.stage(state.stage);
  stage_ = state.stage;
  rest_.start_stage(info, header_.has_time);
  levels_.start_stage(info);
  is_new_ = false;
}

void Alarm::take(const PathPoint& point) {
  for (const PathPoint& driven : rest_.add(point)) {
    limit_.add(driven);
    levels_.add(driven);
    is_new_ = true;
  }
}

void Alarm::watch(const State& state) {
  if (!complete(state)) return;
  if (stage_ != state.stage) start_stage(state);
  latest_ = state;
  if (!is_watched(header_.stage(state.stage))) return;
  if (const auto sample = sampler_.sample(state)) rates_.add(*sample);
  const auto eta = levels_.eta_forecast();
  const auto inside =
      eta ? limit_.inside(*eta, static_cast<double>(state.reading)) : std::optional<bool>();
  const bool changed = levels_.look(state, inside);
  if (changed) say(state);
  if (!eta || !(is_new_ || changed)) return;
  is_new_ = false;
  if (is_heard(listeners_, &AlarmListener::foreseen))
    tell(listeners_, &AlarmListener::foreseen, *levels_.outlook(state));
}

void Alarm::say(const State& state) {
  const WarningLevel level = levels_.level();
  if (level == WarningLevel::none) return take_back(state, "");
  const auto outlook = levels_.outlook(state);
  if (level == WarningLevel::approaching) approaching_ = outlook, imminent_.reset();
  if (level == WarningLevel::imminent) imminent_ = outlook;
  tell(listeners_, &AlarmListener::happened, level_event(level, *outlook));
}

/// Says so where something had been said that no loss has made true.
void Alarm::take_back(const State& state, const std::string& reason) {
  if ((!approaching_ && !imminent_) || levels_.level() == WarningLevel::lost) return;
  approaching_.reset();
  imminent_.reset();
  tell(listeners_, &AlarmListener::happened,
       withdrawal_event(state, header_.has_time, levels_.outlook(state), reason));
}

void Alarm::interrupt(const std::string& reason) {
  if (!latest_) return;
  take_back(*latest_, reason);
  stage_.reset();
}

}  // namespace triax::lab
