// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/alarm.hpp"

#include "lab/base/listeners.hpp"
#include "lab/measured/path_sampler.hpp"
#include "lab/warning/warning_words.hpp"

namespace triax::lab {

Alarm::Alarm(const RecordHeader& header, AlarmListeners listeners, const EarlierTests& earlier)
    : header_(header),
      listeners_(std::move(listeners)),
      limit_(header.specimen),
      levels_(header.has_time, earlier) {}

void Alarm::start_stage(const State& state) {
  take_back(state, "its stage ended");
  stage_ = state.stage;
  levels_.start_stage(header_.stage(state.stage), fluid_);
}

void Alarm::watch(const State& state) {
  if (!complete(state)) return;
  if (stage_ != state.stage) start_stage(state);
  latest_ = state;
  if (!is_watched(header_.stage(state.stage))) return fluid_.add(state, header_.stage(state.stage));
  const bool is_new = levels_.add(state);
  if (is_new) limit_.add(static_cast<double>(state.reading), state.q, state.p_eff);
  const auto eta = levels_.eta_forecast();
  const double q = eta ? *eta * state.p_eff : 0;  // at the p' of now
  const auto inside = eta ? limit_.inside(q, state.p_eff, static_cast<double>(state.reading))
                          : std::optional<bool>();
  const bool changed = levels_.look(inside, eta ? limit_.below(q, state.p_eff) : 1);
  if (changed) say(state);
  if (!eta || !(is_new || changed)) return;
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
  levels_.forget();
  stage_.reset();
}

}  // namespace triax::lab
