// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <thread>
#include <utility>

#include "lab/base/listeners.hpp"
#include "lab/collapse/fall_watch.hpp"
#include "lab/collapse/monitor.hpp"
#include "lab/health/gaps.hpp"
#include "lab/health/judged_states.hpp"
#include "lab/measured/instant.hpp"
#include "lab/measured/path_sampler.hpp"
#include "lab/measured/undrained_strength.hpp"
#include "lab/reduction/cross_checks.hpp"
#include "lab/warning/alarm.hpp"
#include "lab/warning/warning_words.hpp"

namespace triax::lab {
namespace {

using Clock = std::chrono::steady_clock;

/// Holds the stream back to `speed` times the clock; results do not depend on it.
class Pace {
 public:
  explicit Pace(const SessionOptions& options) : options_(options) {}
  /// Waits until a reading is due; less if the test is to stop.
  void wait_for(double time_s) {
    if (options_.speed <= 0 || std::isnan(time_s)) return;
    if (std::isnan(first_)) first_ = time_s;
    const std::chrono::duration<double> after((time_s - first_) / options_.speed);
    const auto due = start_ + std::chrono::duration_cast<Clock::duration>(after);
    constexpr std::chrono::milliseconds kLook{100};
    while (options_.stop && due - Clock::now() > kLook) {
      if (options_.stop()) return;
      std::this_thread::sleep_for(kLook);
    }
    std::this_thread::sleep_until(due);
  }

 private:
  const SessionOptions& options_;
  double first_ = kMissing;
  Clock::time_point start_ = Clock::now();
};

Event stage_event(const RecordHeader& header, const Reading& reading) {
  const StageInfo* stage = header.stage(reading.stage);
  std::string detail = "stage " + std::to_string(reading.stage);
  if (stage && !stage->name.empty()) detail += ": " + stage->name;
  Event event{
      .reading = reading.number, .time_s = {}, .kind = EventKind::stage_started, .detail = detail};
  if (header.has_time) event.time_s = reading.time_s;
  return event;
}

Event sensor_event(const SensorFinding& finding) {
  return {.reading = finding.from,
          .time_s = finding.from_time_s,
          .kind = EventKind::sensor_fault,
          .detail = describe(finding)};
}

/// Takes back what was measured with a sensor that could not be believed.
void take_back(const JudgedStates& states, TestSummary& summary) {
  constexpr ChannelSet kPressures =
      channel_bit(Quantity::cell_pressure) | channel_bit(Quantity::pore_pressure);
  constexpr ChannelSet kDimensions =
      channel_bit(Quantity::axial_displacement) | channel_bit(Quantity::back_volume);
  Consolidation& c = summary.consolidation;
  if (states.wrong_at_shear() & (kPressures | channel_bit(Quantity::axial_force)))
    c.p_eff_pa.reset();
  if (states.wrong_at_shear() & kDimensions) {
    c.void_ratio.reset();
    c.height_m.reset();
    c.diameter_m.reset();
  }
  if (!(states.wrong_in_b_check() & kPressures)) return;
  c.b_value.reset();
  std::erase_if(summary.checks,
                [](const Check& check) { return check.kind == CheckKind::b_value; });
}

std::string answer(const Collapse& c) {
  if (!c.detected()) return "no collapse";
  return c.onset ? fmt::format("{} at reading {}", to_string(c.kind), c.onset->reading)
                 : std::string(to_string(c.kind));
}

/// Why the verdict hangs on what nobody said; empty where it does not.
std::optional<std::string> contradiction(const Collapse& taken,
                                         const std::vector<Otherwise>& others) {
  for (const Otherwise& other : others)
    if (other.collapse.judged && other.collapse.detected() != taken.detected())
      return fmt::format(
          "the assessment depends on an assumption: {}, which gives {}; {} gives {}. State which "
          "is right with --set",
          other.taken, answer(taken), other.said, answer(other.collapse));
  return std::nullopt;
}

std::string told_of(const EarlierTests& earlier) {
  std::string names;
  for (const EarlierTest& test : earlier.all()) names += (names.empty() ? "" : ", ") + test.name;
  return "the alarm used earlier tests of this sand: " + names;
}

/// One test on its way through the stream.
class SessionRun {
 public:
  SessionRun(BackEnd& back_end, const SessionOptions& options, const SessionListeners& listeners)
      : back_end_(back_end),
        options_(options),
        listeners_(listeners),
        reduction_(back_end.header(), options.reduction),
        monitor_(back_end.header(), {monitor_listener()}),
        alarm_(back_end.header(), {alarm_listener()}, options.earlier),
        fall_watch_(back_end.header()),
        states_(back_end.header()),
        cross_checks_(back_end.header()),
        total_stress_(back_end.header().is_total_stress()),
        pace_(options) {}

  TestSummary run() {
    notify(listeners_, &SessionListener::started, back_end_.header());
    Reading reading;
    while (back_end_.next(reading)) {
      pace_.wait_for(reading.time_s);
      take(reading);
      if (options_.stop && options_.stop()) {
        abort(reading);
        break;
      }
    }
    report_rig_events();
    ended_ = true;
    states_.finish();
    report_sensors();
    pass_on();
    summarise();
    notify(listeners_, &SessionListener::progressed, 1.0);
    return std::move(summary_);
  }

 private:
  CollapseListener monitor_listener();
  AlarmListener alarm_listener();
  void take(const Reading& reading);
  void report_event(Event event) {
    if (!ended_) event.detected_at = last_reading_;
    notify(listeners_, &SessionListener::happened, event);
  }
  void report_rig_events() {
    for (const Event& event : back_end_.events()) report_event(event);
  }
  void pass_on();
  void report_impossible(const JudgedStates::Judged& judged);
  void report_sensors();
  void watch_fall(const State& state);
  void pass_onset();
  void heed(const State& state);
  void ask_guard(const State& state);
  void know_the_fall(Collapse& collapse) const;
  void tell_progress();
  void abort(const Reading& reading);
  void keep_run_away(Collapse& collapse);
  void end_while_imminent(Collapse& collapse) const;
  void summarise_total_stress();
  void summarise();

  BackEnd& back_end_;
  const SessionOptions& options_;
  const SessionListeners& listeners_;
  Reduction reduction_;
  Gaps gaps_;
  CollapseMonitor monitor_;
  Alarm alarm_;
  FallWatch fall_watch_;
  std::optional<double> work_;  ///< normalised, at the latest point of second-order work
  std::optional<Event> lost_;   ///< the first fall that was seen
  std::pair<std::optional<Forecast>, std::optional<Forecast>> acted_on_;  ///< approaching, imminent
  WarningLevel heeded_ = WarningLevel::none;
  std::optional<State> latest_;
  std::optional<double> axial_strain_;  ///< the latest that is known
  JudgedStates states_;
  CrossChecks cross_checks_;
  const bool total_stress_;
  UndrainedStrengthFinder undrained_strength_;  ///< of a test in total stresses
  Collapse until_mark_;
  TestSummary summary_;
  Pace pace_;
  std::optional<int> stage_;
  std::optional<Moment> last_reading_;
  bool onset_passed_ = false;  ///< in the stage under way, whose q is still held
  bool impossible_ = false;    ///< the latest state from the sensor checks
  bool ended_ = false;         ///< what is found from now on was not known while the test ran
  std::vector<Warning> aborted_;
  Clock::time_point next_progress_ = Clock::now();
};

CollapseListener SessionRun::monitor_listener() {
  return {.second_order_work =
              [this](const SecondOrderWorkPoint& p) {
                gaps_.add(p);
                work_ = p.work.normalised;
                notify(listeners_, &SessionListener::second_order_work, p);
              },
          .happened =
              [this](const Event& e) {
                if (e.kind == EventKind::loss_of_sustainability) pass_onset();
                report_event(e);
              }};
}

AlarmListener SessionRun::alarm_listener() {
  return {
      .foreseen = [this](const Forecast& o) { notify(listeners_, &SessionListener::foreseen, o); },
      .happened = [this](const Event& e) { report_event(e); }};
}

void SessionRun::take(const Reading& reading) {
  if (latest_) ask_guard(*latest_);  // before its stage began
  last_reading_ = Moment{reading.number, {}};
  if (back_end_.header().has_time) last_reading_->time_s = reading.time_s;
  if (stage_ != reading.stage) report_event(stage_event(back_end_.header(), reading));
  if (stage_ != reading.stage && reading.line > 0)
    summary_.ending.stage_lines.emplace_back(reading.number, reading.line);
  if (stage_ != reading.stage && std::exchange(onset_passed_, false)) alarm_.lose();
  stage_ = reading.stage;
  report_rig_events();
  const State state = reduction_.reduce(reading);
  notify(listeners_, &SessionListener::scanned, reading, state);
  states_.add(reading, state);
  report_sensors();
  if (!total_stress_ && states_.is_possible(state)) {
    alarm_.watch(state);
    watch_fall(state);
  }
  heed(state);
  pass_on();
  if (++summary_.readings % 1024 == 0 || options_.speed > 0) tell_progress();
}

/// What came to light about sensors with the last reading, or with the end of the record.
void SessionRun::report_sensors() {
  for (const SensorFinding& finding : states_.health().news()) {
    report_event(sensor_event(finding));
    notify(listeners_, &SessionListener::doubted, finding);
    alarm_.interrupt(describe(finding));
    if (finding.channel == Quantity::axial_displacement || finding.channel == Quantity::axial_force)
      fall_watch_.interrupt();
  }
}

/// At held q the fall is still to come: the alarm continues until it or the end of the stage.
void SessionRun::pass_onset() {
  const StageInfo* stage = stage_ ? back_end_.header().stage(*stage_) : nullptr;
  onset_passed_ = stage && stage->control == AxialControl::constant_q;
  if (!onset_passed_) alarm_.lose();
}

void SessionRun::watch_fall(const State& state) {
  const auto fall = fall_watch_.watch(state);
  if (!fall) return;
  alarm_.lose();
  const Event event{.reading = fall->instant.reading,
                    .time_s = fall->instant.time_s,
                    .kind = EventKind::lost,
                    .detail = fall->evidence,
                    .detected_at = last_reading_};
  if (!lost_) lost_ = event;
  report_event(event);
}

/// What the alarm says is told to the rig at once: the guard of its programme may act on it.
void SessionRun::heed(const State& state) {
  if (!std::isnan(state.strain.axial)) axial_strain_ = state.strain.axial;
  latest_ = state;
  if (std::exchange(heeded_, alarm_.level()) != alarm_.level()) back_end_.heed(heeded_);
  ask_guard(state);
}

/// Whether it acted at that state.
void SessionRun::ask_guard(const State& state) {
  const auto done = back_end_.guarded();
  if (!done) return;
  // Its stage ends here, and with it what the alarm says of it.
  acted_on_ = {alarm_.approaching(), alarm_.imminent()};
  GuardOutcome& guard = summary_.guard.emplace();
  guard.level = heeded_;
  guard.done = *done;
  guard.at = instant_of(state, back_end_.header().has_time);
  guard.second_order_work_normalised = work_;
  report_event({.reading = guard.at.reading,
                .time_s = guard.at.time_s,
                .kind = EventKind::guarded,
                .detail = describe(guard)});
}

/// A collapse that came with the fall was known with it, whatever it took to judge it.
void SessionRun::know_the_fall(Collapse& collapse) const {
  if (!lost_) return;
  const auto earlier = [&](std::optional<Moment>& known) {
    if (!known || lost_->detected_at->reading < known->reading) known = lost_->detected_at;
  };
  const auto knew = [&](std::int64_t reading) { return reading <= lost_->detected_at->reading; };
  if (collapse.detected() && collapse.onset && knew(collapse.onset->reading))
    earlier(collapse.onset_detected_at);
  if (collapse.loss_of_control && knew(collapse.loss_of_control->reading))
    earlier(collapse.loss_of_control_detected_at);
  for (Criterion& one : collapse.criteria)
    if (one.name == LossOfControl::kName && one.found() && one.reading && knew(*one.reading))
      earlier(one.detected_at);
}

/// Tells of the first of impossible states in a row.
void SessionRun::report_impossible(const JudgedStates::Judged& judged) {
  if (std::exchange(impossible_, judged.impossible) || !judged.impossible) return;
  Event event{.reading = judged.reading.number,
              .time_s = {},
              .kind = EventKind::sensor_fault,
              .detail = "impossible state: " + judged.reason};
  if (back_end_.header().has_time) event.time_s = judged.reading.time_s;
  report_event(event);
}

/// To the monitor goes what has been judged by now.
void SessionRun::pass_on() {
  while (const auto* judged = states_.next()) {
    cross_checks_.add(believed(*judged), judged->state);
    if (judged->mark) until_mark_ = monitor_.so_far();
    if (total_stress_) {
      const bool in_shear = is_watched(back_end_.header().stage(judged->state.stage));
      if (in_shear && (judged->live || judged->axis_live)) undrained_strength_.add(judged->state);
      continue;
    }
    report_impossible(*judged);
    if (judged->axis_live) monitor_.watch_axis(axis_of(*judged));
    if (!judged->live) continue;
    if (judged->after_gap) {
      monitor_.interrupt();
      gaps_.end(judged->reading.number);
    }
    monitor_.watch(judged->state, ended_ ? std::nullopt : last_reading_);
  }
}

void SessionRun::tell_progress() {
  const auto now = Clock::now();
  if (now < next_progress_) return;
  notify(listeners_, &SessionListener::progressed, back_end_.progress());
  next_progress_ = now + std::chrono::milliseconds(50);
}

/// Breaks the test off after this reading and sees to it that the record says so.
void SessionRun::abort(const Reading& reading) {
  const std::string when = back_end_.header().has_time
                               ? fmt::format("at {:.6g} s", reading.time_s)
                               : fmt::format("after reading {}", reading.number);
  const std::string reason = "aborted by the operator " + when;
  if (!back_end_.abort(reason)) aborted_.push_back({0, reason});
}

/// A specimen that ran away did so whatever may be wrong with its pore pressure, its volume or the
/// valve.
void SessionRun::keep_run_away(Collapse& collapse) {
  if (collapse.judged || !states_.trusts_axis()) return;
  Collapse axis = monitor_.of_the_axis();
  if (!axis.detected()) return;
  const Collapse seen = axis;
  axis.end_at(collapse.judged_until, collapse.judged_until_reason);
  axis.loss_of_control = seen.loss_of_control;
  axis.loss_of_control_detected_at = seen.loss_of_control_detected_at;
  collapse = std::move(axis);
}

/// In total stresses there is a strength, and nothing is known of a collapse.
void SessionRun::summarise_total_stress() {
  const RecordHeader& header = back_end_.header();
  summary_.undrained_strength = undrained_strength_.result(header.has_time);
  if (const auto& peak = undrained_strength_.peak())
    summary_.peak = instant_of(*peak, header.has_time);
  summary_.collapse.withhold(
      fmt::format("{} is a test in total stresses: its result is c_u, and collapse is a matter of "
                  "effective stresses",
                  header.programme));
}

/// No all-clear while an onset is forecast within the next readings.
void SessionRun::end_while_imminent(Collapse& collapse) const {
  const auto& warned = collapse.imminent;
  if (!warned || warned->cyclic || collapse.detected() || !last_reading_) return;
  if (alarm_.level() == WarningLevel::imminent && collapse.inside_limit_surface != false)
    collapse.end_at(last_reading_->reading,
                    fmt::format("the record ends while the warning `imminent` of reading {} is in "
                                "force",
                                warned->reading));
}

void SessionRun::summarise() {
  const std::vector<Warning>& of_record = back_end_.header().warnings;
  Collapse& collapse = summary_.collapse;
  collapse = monitor_.finish();
  if (states_.ends_at_mark()) collapse = until_mark_;
  states_.bound(collapse);
  keep_run_away(collapse);
  know_the_fall(collapse);
  collapse.approaching = acted_on_.first ? acted_on_.first : alarm_.approaching();
  collapse.imminent = acted_on_.second ? acted_on_.second : alarm_.imminent();
  end_while_imminent(collapse);
  // What was about to happen when the test broke off is in no reading. A failure that was told is.
  if (const std::string& why = back_end_.header().cut_short; !why.empty() && !collapse.onset)
    collapse.end_at(last_reading_ ? std::optional(last_reading_->reading) : std::nullopt, why);
  if (options_.otherwise && collapse.judged)
    if (const auto doubt = contradiction(collapse, options_.otherwise())) collapse.withhold(*doubt);
  const auto caveat = gaps_.caveat(collapse);
  if (caveat && collapse.judged_until_reason.empty()) collapse.judged_until_reason = *caveat;
  if (summary_.guard) {
    summary_.guard->last_axial_strain = axial_strain_;
    if (options_.without_guard) summary_.guard->without = options_.without_guard();
  }
  summary_.peak = monitor_.peak();
  if (total_stress_) summarise_total_stress();
  summary_.cyclic = monitor_.cyclic();
  summary_.consolidation = reduction_.consolidation();
  summary_.truth = back_end_.truth();
  summary_.membrane_correction = reduction_.membrane_correction();
  summary_.checks = reduction_.checks(back_end_.header().back_volume_joined);
  const auto& onset = collapse.onset;
  auto crossed = cross_checks_.checks(onset ? std::optional(onset->reading) : std::nullopt);
  std::ranges::move(back_end_.checks(), std::back_inserter(crossed));
  summary_.checks.insert(summary_.checks.end(), crossed.begin(), crossed.end());
  take_back(states_, summary_);
  summary_.ending.warnings = static_cast<std::int64_t>(of_record.size() + aborted_.size());
  summary_.ending.cut_short = back_end_.header().cut_short;
  summary_.ending.back_volume_joined = back_end_.header().back_volume_joined;
  for (const auto& warnings :
       {of_record, aborted_, reduction_.warnings(), warnings_of(crossed), states_.warnings()})
    summary_.warnings.insert(summary_.warnings.end(), warnings.begin(), warnings.end());
  if (!options_.earlier.empty()) summary_.warnings.push_back({0, told_of(options_.earlier)});
  if (caveat) summary_.warnings.push_back({0, "the onset of collapse is " + *caveat});
  if (const auto& c_u = summary_.undrained_strength; c_u && c_u->at.q_pa < 0)
    summary_.warnings.push_back(
        {0,
         "q is negative: c_u is calculated for extension; if compression is negative in the file, "
         "write sign = -1 for force and displacement in a dialect"});
}

}  // namespace

TestSummary run_session(BackEnd& back_end, const SessionOptions& options,
                        const SessionListeners& listeners) {
  return SessionRun(back_end, options, listeners).run();
}

}  // namespace triax::lab
