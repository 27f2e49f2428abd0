// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/alarm.hpp"

#include <algorithm>

#include "lab/base/listeners.hpp"
#include "lab/measured/path_sampler.hpp"
#include "lab/warning/warning_words.hpp"

namespace triax::lab {

Alarm::Alarm(const RecordHeader& header, AlarmListeners listeners, const EarlierTests& earlier)
    : header_(header),
      listeners_(std::move(listeners)),
      limit_(header.specimen),
      volume_(header.specimen),
      levels_(header.has_time, earlier),
      cyclic_(header.has_time) {}

WarningLevel Alarm::level() const {
  const WarningLevel by_path = levels_.level();
  return cyclic_.is_imminent() ? std::max(by_path, WarningLevel::imminent) : by_path;
}

void Alarm::lose() {
  levels_.lose();
  cyclic_.reset();
  is_lost_ = true;
}

/// Half cycles may be stages of their own.
bool Alarm::is_cyclic_watched(const StageInfo* stage) const {
  return !is_lost_ && is_watched(stage) && stage && stage->drainage == Drainage::closed &&
         stage->control != AxialControl::displacement;
}

void Alarm::start_stage(const State& state) {
  const StageInfo* stage = header_.stage(state.stage);
  if (!is_watched(stage)) is_lost_ = false;
  if (!cyclic_.is_imminent() || !is_cyclic_watched(stage)) take_back(state, "its stage ended");
  const bool is_same_specimen = stage && stage->drainage == Drainage::closed &&
                                (is_watched(stage) || stage->role == StageRole::hold);
  if (!is_same_specimen)
    cyclic_.reset();
  else if (!is_cyclic_watched(stage))
    cyclic_.interrupt();
  stage_ = state.stage;
  levels_.start_stage(stage, volume_);
}

void Alarm::watch(const State& measured) {
  if (!complete(measured)) return;
  const StageInfo* stage = header_.stage(measured.stage);
  const State state = volume_.with_fluid(measured, stage);
  if (stage_ != state.stage) start_stage(state);
  latest_ = state;
  if (!is_watched(stage)) return;
  const WarningLevel before = level();
  if (is_cyclic_watched(stage)) cyclic_.add(state);
  const bool is_new = levels_.add(state);
  if (is_new) limit_.add(static_cast<double>(state.reading), state.q, state.p_eff);
  if (is_cyclic_watched(stage) && cyclic_.is_cyclic()) return watch_cycles(state, before);
  const auto eta = levels_.eta_forecast();
  const double q = eta ? *eta * state.p_eff : 0;  // at the p' of now
  const auto inside = eta ? limit_.inside(q, state.p_eff, static_cast<double>(state.reading))
                          : std::optional<bool>();
  const bool changed = levels_.look(inside, eta ? limit_.below(q, state.p_eff) : 1);
  if (level() != before) say(state);
  if (!eta || !(is_new || changed)) return;
  if (is_heard(listeners_, &AlarmListener::foreseen))
    notify(listeners_, &AlarmListener::foreseen, *levels_.current_forecast(state));
}

/// The forecast of η is for a load that grows.
void Alarm::watch_cycles(const State& state, WarningLevel before) {
  if (levels_.level() != WarningLevel::none) {
    levels_.forget();
    levels_.start_stage(header_.stage(state.stage), volume_);
    if (!cyclic_.is_imminent()) return take_back(state, "the load is cyclic");
  }
  if (level() != before) say(state);
}

Forecast Alarm::cyclic_forecast(const State& state) const {
  Forecast forecast{
      .reading = state.reading, .eta = kMissing, .eta_low = kMissing, .eta_high = kMissing};
  if (header_.has_time) forecast.time_s = state.time_s;
  forecast.cyclic = CyclicForecast{cyclic_.probability(), cyclic_.cycles()};
  return forecast;
}

/// Of the cyclic warning while it is in force, else of η.
std::optional<Forecast> Alarm::current_forecast(const State& state) const {
  return cyclic_.is_imminent() ? cyclic_forecast(state) : levels_.current_forecast(state);
}

void Alarm::say(const State& state) {
  const WarningLevel level = this->level();
  if (level == WarningLevel::none) return take_back(state, "");
  const auto forecast = current_forecast(state);
  if (level == WarningLevel::approaching) approaching_ = forecast, imminent_.reset();
  if (level == WarningLevel::imminent) imminent_ = forecast;
  Event event = level_event(level, *forecast);
  if (forecast->cyclic) event.detail += restart_words(cyclic_);
  notify(listeners_, &AlarmListener::happened, event);
}

/// Says so where something had been said that no loss has made true.
void Alarm::take_back(const State& state, const std::string& reason) {
  if ((!approaching_ && !imminent_) || levels_.level() == WarningLevel::lost) return;
  const bool was_cyclic = imminent_ && imminent_->cyclic;
  approaching_.reset();
  imminent_.reset();
  const auto forecast = was_cyclic ? cyclic_forecast(state) : levels_.current_forecast(state);
  notify(listeners_, &AlarmListener::happened,
         withdrawal_event(state, header_.has_time, forecast, reason));
}

void Alarm::interrupt(const std::string& reason) {
  if (!latest_) return;
  take_back(*latest_, reason);
  levels_.forget();
  cyclic_.interrupt();
  stage_.reset();
}

}  // namespace triax::lab
