// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/warning/heard.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace triax::bench {
namespace {

std::optional<lab::WarningLevel> level_of(lab::EventKind kind) {
  using enum lab::EventKind;
  switch (kind) {
    case approaching:
      return lab::WarningLevel::approaching;
    case imminent:
      return lab::WarningLevel::imminent;
    case warning_withdrawn:
      return lab::WarningLevel::none;
    case loss_of_sustainability:
      return lab::WarningLevel::lost;
    default:
      return std::nullopt;
  }
}

bool is_alarming(lab::WarningLevel level) {
  return level == lab::WarningLevel::imminent || level == lab::WarningLevel::lost;
}

}  // namespace

lab::SessionListener Heard::listener() {
  lab::SessionListener listener;
  listener.scanned = [this](const lab::Reading& reading, const lab::State& state) {
    now_s_ = reading.time_s;
    eta_ = state.eta();
    if (stage_ != state.stage) begins_.push_back({state.stage, now_s_, reading.number});
    stage_ = state.stage;
    times_.push_back(now_s_);
  };
  listener.second_order_work = [this](const lab::SecondOrderWorkPoint&) {
    ++points_;
    if (level() != lab::WarningLevel::none) ++wrong_points_;
  };
  listener.foreseen = [this](const lab::Forecast& forecast) {
    forecasts_.push_back({now_s_, *stage_, eta_, forecast});
  };
  listener.happened = [this](const lab::Event& event) {
    if (const auto level = level_of(event.kind)) levels_.push_back({now_s_, *level});
  };
  return listener;
}

Heard::Begin Heard::stage_at(double time_s) const {
  Begin begin{};
  for (const Begin& one : begins_)
    if (one.time_s <= time_s) begin = one;
  return begin;
}

/// Since when `imminent` (or `lost`) had stood at that time, without having been taken back.
std::optional<double> Heard::stood_since(double time_s) const {
  std::optional<double> since;
  for (const Level& one : levels_) {
    if (one.time_s > time_s) break;
    if (!is_alarming(one.level)) since.reset();
    if (is_alarming(one.level) && !since) since = one.time_s;
  }
  return since;
}

void Heard::judge_collapse(const lab::Truth& truth, AlarmTrial& r) const {
  const double onset_s = *truth.time_s;
  const Begin begin = stage_at(onset_s);
  const auto reading = std::ranges::lower_bound(times_, onset_s) - times_.begin();
  r.eta = *truth.q_pa / *truth.p_eff_pa;
  r.stage_s = onset_s - begin.time_s;
  r.stage_readings = reading - begin.reading;
  r.fall_s = truth.run_aways.empty() ? onset_s : std::max(onset_s, truth.run_aways.front().start_s);
  const auto last =
      std::min<std::size_t>(static_cast<std::size_t>(reading) + 10, times_.size() - 1);
  r.imminent_s = stood_since(r.under_force ? r.fall_s : times_[last]);
  for (std::size_t i = 0; i < kLeft.size(); ++i) {
    const double then = onset_s - kLeft[i] * r.stage_s;
    const Forecast* stands = nullptr;
    for (const Forecast& one : forecasts_)
      if (one.known_s <= then && one.stage == begin.stage) stands = &one;
    r.looks[i].reset();
    if (!stands) continue;
    const lab::Forecast& o = stands->forecast;
    r.looks[i] = Look{.error = o.eta - r.eta,
                      .covered = o.eta_low <= r.eta && r.eta <= o.eta_high,
                      .now = stands->eta_now};
  }
}

void Heard::judge(const lab::Truth* truth, AlarmTrial& r) const {
  r.points = points_;
  r.wrong_points = wrong_points_;
  r.approaching_at_end = level() == lab::WarningLevel::approaching;
  r.imminent =
      std::ranges::any_of(levels_, [](const Level& one) { return is_alarming(one.level); });
  r.said.clear();
  for (const Level& one : levels_)
    r.said += fmt::format(" {} {:.0f} s", lab::to_string(one.level), one.time_s);
  if (truth) judge_collapse(*truth, r);
}

}  // namespace triax::bench
