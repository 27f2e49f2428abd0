// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/warning/alarm_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lab/measured/path_sampler.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

namespace triax::bench {
namespace {

/// All that was said, in order.
struct Heard {
  struct Level {
    double time_s;
    std::int64_t reading;
    lab::WarningLevel level;
  };
  struct Forecast {
    double known_s;
    int stage;
    lab::Outlook outlook;
  };
  std::vector<double> times;
  std::vector<Level> levels;
  std::vector<Forecast> forecasts;
  struct Begin {
    int stage;
    double time_s;
    std::int64_t reading;
  };
  std::vector<Begin> begins;
  std::int64_t points = 0, wrong_points = 0;

  lab::WarningLevel level() const {
    return levels.empty() ? lab::WarningLevel::none : levels.back().level;
  }
};

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

/// Since when `imminent` (or `lost`) had stood at that time, without having been taken back.
std::optional<double> stood_since(const Heard& heard, double time_s) {
  std::optional<double> since;
  for (const auto& one : heard.levels) {
    if (one.time_s > time_s) break;
    const bool said =
        one.level == lab::WarningLevel::imminent || one.level == lab::WarningLevel::lost;
    if (!said) since.reset();
    if (said && !since) since = one.time_s;
  }
  return since;
}

void judge_collapse(const lab::Truth& truth, const Heard& heard, AlarmTrial& r) {
  const double onset_s = *truth.time_s;
  const double eta = *truth.q_pa / *truth.p_eff_pa;
  Heard::Begin begin{};
  for (const auto& one : heard.begins)
    if (one.time_s <= onset_s) begin = one;
  const auto reading = std::ranges::lower_bound(heard.times, onset_s) - heard.times.begin();
  r.stage_s = onset_s - begin.time_s;
  r.stage_readings = reading - begin.reading;
  r.fall_s = truth.run_aways.empty() ? onset_s : std::max(onset_s, truth.run_aways.front().start_s);
  const auto last =
      std::min<std::size_t>(static_cast<std::size_t>(reading) + 10, heard.times.size() - 1);
  r.imminent_s = stood_since(heard, r.under_force ? r.fall_s : heard.times[last]);
  for (std::size_t i = 0; i < kLeft.size(); ++i) {
    const double then = onset_s - kLeft[i] * r.stage_s;
    const Heard::Forecast* stands = nullptr;
    for (const auto& one : heard.forecasts)
      if (one.known_s <= then && one.stage == begin.stage) stands = &one;
    if (!stands) continue;
    const lab::Outlook& o = stands->outlook;
    r.looks[i] = Look{o.eta - eta, o.eta_low <= eta && eta <= o.eta_high};
  }
}

/// By instruments without noise or steps.
double least_work(lab::Programme programme, std::uint64_t seed) {
  for (lab::Transducer& t : programme.transducers) t.noise_rms = 0, t.step = 0;
  lab::VirtualRig rig(std::move(programme), seed);
  double least = 1;
  lab::SessionListener listener;
  listener.second_order_work = [&](const lab::SecondOrderWorkPoint& point) {
    least = std::min(least, point.work.normalised);
  };
  lab::run_session(rig, {}, {listener});
  return least;
}

}  // namespace

lab::Programme varied_for_alarm(const Subject& subject, std::uint64_t seed,
                                Instruments& instruments) {
  lab::Programme programme = varied(subject, seed);
  instruments = static_cast<Instruments>(std::min(2, static_cast<int>(3 * choice(seed, 10))));
  if (instruments == Instruments::good)
    for (lab::Transducer& t : programme.transducers) t.noise_rms *= 0.5;
  if (instruments == Instruments::cheap)
    for (lab::Transducer& t : programme.transducers) t.step *= 8, t.noise_rms *= 3;
  const double slower = std::exp2(std::floor(7 * choice(seed, 11)) - 2);
  for (lab::Stage& stage : programme.stages) {
    if (stage.role != lab::StageRole::shear) continue;
    lab::Logging& logging = stage.logging;
    const double interval = std::clamp(logging.interval_s * slower, 0.1, 60.0);
    logging.averaging_s *= interval / logging.interval_s;
    logging.interval_s = interval;
  }
  if (choice(seed, 12) < 0.25) programme.specimen.saturation = 1 - 0.01 - 0.015 * choice(seed, 14);
  return interrupted(std::move(programme), interruption(seed), seed);
}

AlarmTrial run_alarm_trial(const Subject& subject, std::uint64_t seed) {
  AlarmTrial r;
  const lab::Programme programme = varied_for_alarm(subject, seed, r.instruments);
  lab::VirtualRig rig(programme, seed);
  Heard heard;
  double now_s = 0;
  std::optional<int> stage;
  lab::SessionListener listener;
  listener.scanned = [&](const lab::Reading& reading, const lab::State& state) {
    now_s = reading.time_s;
    if (stage != state.stage) heard.begins.push_back({state.stage, now_s, reading.number});
    stage = state.stage;
    heard.times.push_back(now_s);
  };
  listener.second_order_work = [&](const lab::SecondOrderWorkPoint&) {
    ++heard.points;
    if (heard.level() != lab::WarningLevel::none) ++heard.wrong_points;
  };
  listener.foreseen = [&](const lab::Outlook& outlook) {
    heard.forecasts.push_back({now_s, *stage, outlook});
  };
  listener.happened = [&](const lab::Event& event) {
    if (const auto level = level_of(event.kind))
      heard.levels.push_back({now_s, event.reading, *level});
  };
  const lab::TestSummary summary = lab::run_session(rig, {}, {listener});

  r.fill(programme, subject.collapses, seed);
  r.air = programme.specimen.saturation < 1;
  r.interruption = interruption(seed);
  r.lost = summary.truth && summary.truth->lost_sustainability;
  for (const lab::StageInfo& info : rig.header().stages)
    if (lab::is_watched(&info)) {
      r.under_force =
          info.control == lab::AxialControl::load || info.control == lab::AxialControl::constant_q;
    }
  for (const lab::Stage& one : programme.stages)
    if (one.role == lab::StageRole::shear) r.interval_s = one.logging.interval_s;
  r.points = heard.points;
  r.wrong_points = heard.wrong_points;
  r.approaching_at_end = heard.level() == lab::WarningLevel::approaching;
  for (const auto& one : heard.levels)
    r.imminent = r.imminent || one.level == lab::WarningLevel::imminent ||
                 one.level == lab::WarningLevel::lost;
  for (const auto& one : heard.levels)
    r.said += fmt::format(" {} {:.0f} s", lab::to_string(one.level), one.time_s);
  if (r.lost) judge_collapse(*summary.truth, heard, r);
  if (!r.collapses) r.least_work = least_work(programme, seed);
  return r;
}

}  // namespace triax::bench
