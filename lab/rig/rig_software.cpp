// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/rig_software.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/rig/axis_control.hpp"
#include "lab/rig/logger.hpp"
#include "lab/rig/missed_readings.hpp"
#include "lab/rig/ramp_target.hpp"
#include "lab/rig/rig_guard.hpp"
#include "lab/rig/stage_progress.hpp"
#include "lab/rig/stage_words.hpp"
#include "lab/rig/strain_path_control.hpp"
#include "lab/rig/supervision.hpp"

namespace triax::lab {
namespace {

/// Whether the end of a stage is the target of its own ramp.
bool is_target(const EndCondition& end, EndQuantity pressure, const PressureDemand& ramp) {
  return end.quantity == pressure && ramp.target_pa == end.above.value_or(end.below.value_or(0));
}

/// Fails if the pressure reads other than its target; empty: it does not.
std::optional<Check> missed_target(const Stage& stage, std::string_view name, double target_pa,
                                   double read_pa) {
  const double difference_pa = std::fabs(read_pa - target_pa);
  const double allowed_pa = Supervision::allowed_difference_pa(target_pa);
  if (!(difference_pa > allowed_pa)) return std::nullopt;
  return Check{.kind = CheckKind::stage_target,
               .measured = difference_pa / 1e3,
               .limit = allowed_pa / 1e3,
               .ok = false,
               .note = fmt::format("stage \"{}\" ended at a {} pressure of {:.1f} kPa instead of "
                                   "its target of {:.1f} kPa",
                                   stage.name, name, read_pa / 1e3, target_pa / 1e3)};
}

}  // namespace

struct RigSoftware::Impl {
  /// `fallen`: the cap lies on the stop after a run-away; the record goes on for some readings.
  enum class Mode { running, held, safe, fallen };

  Impl(const GuardedProgramme& all, RecordHeader of_record, std::unique_ptr<Apparatus> driven)
      : guard(all),
        programme(all.programme),
        header(std::move(of_record)),
        apparatus(std::move(driven)),
        logger(programme.transducers),
        seen(header),
        supervision(programme),
        axis(AxisControl::Servo{
            .ideal = programme.frame.bandwidth_hz == 0 && programme.frame.moving_mass_kg == 0,
            .filter_s = programme.frame.servo_filter_s}),
        strain_path(programme.specimen.height_m, programme.frame.servo_filter_s) {}

  const Stage& stage() const { return programme.stages[stage_index]; }
  void warn(const std::string& text) { header.warnings.push_back({0, text}); }
  /// The test ends here without having reached its end.
  void cut(const std::string& why) {
    warn(why);
    header.cut_short = why;
  }
  /// The first cause is the one that counts.
  void end_as(TestEnding::Kind kind, const std::string& reason) {
    if (ending.kind == TestEnding::Kind::completed) ending = {kind, reason};
  }
  void tell(EventKind kind, const std::string& detail) {
    events.push_back({.reading = number, .time_s = time_s, .kind = kind, .detail = detail});
  }

  void look();
  void begin_stage();
  bool met(const EndCondition& end) const;
  void check_targets();
  bool stage_over();
  void hold_by_guard(const std::string& detail);
  void act_as_guard_if_due();
  void act_as_operator();
  bool go(Mode next, EventKind kind, const std::string& detail);
  PlantDemand demand(double dt_s);
  void supervise(double dt_s);
  bool tick(double dt_s);
  bool advance_to_next_scan();
  void check_ranges();

  RigGuard guard;
  Programme programme;
  RecordHeader header;
  std::unique_ptr<Apparatus> apparatus;
  Logger logger;
  Seen seen;
  Supervision supervision;
  AxisControl axis;
  StrainPathControl strain_path;
  StageProgress progress;
  RampTarget cell_target, back_target;
  std::vector<Check> checks;
  std::vector<Event> events;

  Reading reading;  ///< the latest look
  double time_s = 0;
  std::int64_t number = -1;  ///< of the last scan
  std::size_t stage_index = 0;
  Mode mode = Mode::running;
  double late_s = 0;  ///< by how much the last tick was longer than it was meant to be
  MissedReadings missed;
  int safe_readings = 0;
  std::size_t next_action = 0;
  std::optional<double> held_until_s;  ///< by the guard
  PlantDemand before;                  ///< of the last tick
  bool sheared = false;                ///< the first shear stage has begun
  bool finished = false;
  TestEnding ending;
  std::array<bool, kRawQuantityCount> saturation_warned{};
};

void RigSoftware::Impl::look() {
  reading = Reading();
  reading.number = number;
  reading.time_s = time_s;
  const bool paused = mode == Mode::held || mode == Mode::safe;
  reading.stage = static_cast<int>(paused ? programme.stages.size() : stage_index) + 1;
  const double cell_pa = apparatus->devices().cell.asked_pa;
  const double back_pa = apparatus->devices().back.asked_pa;
  apparatus->look(reading);
  cell_target.look(cell_pa, apparatus->devices().cell.asked_pa);
  back_target.look(back_pa, apparatus->devices().back.asked_pa);
  seen.take(reading);
}

void RigSoftware::Impl::begin_stage() {
  seen.begin_stage();
  axis.begin_stage(stage(), seen, apparatus->devices().piston_force_n);
  strain_path.begin_stage(stage(), seen);
  supervision.begin_stage(stage());
  logger.begin(stage().logging, time_s);
  before = {};
  if (stage().role == StageRole::shear && !std::exchange(sheared, true))
    for (const std::string& warning : apparatus->begin_shear()) warn(warning);
  progress.begin_stage(seen);
}

/// A pressure that is the target of the stage's own ramp counts as reached when its controller has
/// come to it, whatever an offset of the transducer says.
bool RigSoftware::Impl::met(const EndCondition& end) const {
  if (is_target(end, EndQuantity::cell_pressure, stage().cell))
    return cell_target.met(end, std::fabs(stage().cell.rate_pa_per_s) * kTick_s);
  if (is_target(end, EndQuantity::back_pressure, stage().back))
    return back_target.met(end, std::fabs(stage().back.rate_pa_per_s) * kTick_s);
  // Its last value stands in for a channel that says nothing; no stage ends by that.
  return Supervision::can_tell(end.quantity, reading, apparatus->devices()) && seen.met(end);
}

/// At the end of a stage: whether the transducers read the pressures that its ramps led to.
void RigSoftware::Impl::check_targets() {
  for (const EndCondition& end : stage().end) {
    const bool cell = is_target(end, EndQuantity::cell_pressure, stage().cell);
    const bool back = is_target(end, EndQuantity::back_pressure, stage().back);
    if ((!cell && !back) || !met(end)) continue;
    if (auto check = missed_target(stage(), cell ? "cell" : "back",
                                   *(cell ? stage().cell : stage().back).target_pa,
                                   seen[cell ? Quantity::cell_pressure : Quantity::back_pressure]))
      checks.push_back(std::move(*check));
  }
}

void RigSoftware::Impl::hold_by_guard(const std::string& detail) {
  go(Mode::held, EventKind::held, "by the intervention: " + detail);
  held_until_s = time_s + guard.hold_s();
}

void RigSoftware::Impl::act_as_guard_if_due() {
  if (mode != Mode::running || !guard.is_due(stage_index, stage())) return;
  const Guard& now = guard.act();
  if (now.action == Guard::Action::safe) {
    const TestEnding before_guard = ending;
    if (go(Mode::safe, EventKind::safe_state, "by the intervention")) ending = before_guard;
    return;
  }
  cut(ended_by_guard(stage(), time_s, describe(now)));
  if (now.action == Guard::Action::hold) return hold_by_guard(describe(now));
  stage_index = guard.successor(stage_index);
  aim(now, seen, programme.specimen.height_m, programme.stages[stage_index]);
  begin_stage();
}

/// True where the stage is over and none follows, or it may not go on.
bool RigSoftware::Impl::stage_over() {
  if (mode == Mode::safe || mode == Mode::fallen) return safe_readings >= kSafeReadings;
  if (mode == Mode::held) return held_until_s && time_s >= *held_until_s;
  // Time may have passed the end of the stage while nothing was controlled.
  if (const std::string& fault = apparatus->devices().fault; !fault.empty()) {
    go(Mode::safe, EventKind::safe_state, fault);
    return false;
  }
  if (std::ranges::any_of(stage().end, [this](const auto& end) { return met(end); })) {
    check_targets();
    if (guard.unloads()) {
      hold_by_guard("q was reduced");
      return false;
    }
    if (!guard.is_followed(stage_index)) return true;
    ++stage_index;
    begin_stage();
    act_as_guard_if_due();
    return false;
  }
  if (seen.stage_time_s() < stage().time_limit_s) return false;
  warn(out_of_time(stage()));
  end_as(TestEnding::Kind::unfinished, out_of_time(stage()));
  return true;
}

/// False where it stays as it is: a safe state is not left.
bool RigSoftware::Impl::go(Mode next, EventKind kind, const std::string& detail) {
  if (mode == next || mode == Mode::safe || mode == Mode::fallen) return false;
  const bool resumed = next == Mode::running;
  mode = next;
  tell(kind, detail);
  if (next == Mode::safe) {
    cut(ended_in_safe_state(stage(), time_s, detail));
    end_as(kind == EventKind::aborted ? TestEnding::Kind::aborted : TestEnding::Kind::safe_state,
           header.cut_short);
  }
  if (resumed) held_until_s.reset();
  if (resumed) axis.resume(seen, apparatus->devices().piston_force_n);
  return true;
}

void RigSoftware::Impl::act_as_operator() {
  for (; next_action < programme.operator_actions.size(); ++next_action) {
    const OperatorAction& action = programme.operator_actions[next_action];
    if (action.at_s > time_s) return;
    if (action.kind == OperatorAction::Kind::hold)
      go(Mode::held, EventKind::held, "by the operator");
    if (action.kind == OperatorAction::Kind::resume)
      go(Mode::running, EventKind::resumed, "by the operator");
    if (action.kind == OperatorAction::Kind::abort)
      go(Mode::safe, EventKind::aborted, "aborted by the operator");
  }
}

PlantDemand RigSoftware::Impl::demand(double dt_s) {
  PlantDemand d;
  d.valve_open = stage().valve_open;
  if (mode != Mode::running) {
    // Without a piston there is nothing to lock.
    if (way_of(stage().axial).drive != AxialWay::Drive::none)
      d.axis.kind = AxisDemand::Kind::crosshead;
    return d;
  }
  d.cell = stage().cell;
  d.back = stage().back;
  d.outflow_m3_per_s = strain_path.outflow_m3_per_s(seen, dt_s);
  const double next_cell_pa =
      process(programme.cell_controller, apparatus->devices().cell.asked_pa, d.cell, dt_s);
  d.axis = axis.demand(seen, next_cell_pa, dt_s);
  return d;
}

void RigSoftware::Impl::supervise(double dt_s) {
  for (const std::string& note : supervision.notes()) {
    warn(note);
    tell(EventKind::device_fault, note);
  }
  if (mode != Mode::running) return;
  Demanded asked;
  asked.force_n = axis.wanted_force_n();
  asked.valve_open = before.valve_open;
  asked.back_by_volume = before.outflow_m3_per_s.has_value();
  asked.cell_pa = apparatus->devices().cell.asked_pa;
  asked.back_pa = apparatus->devices().back.asked_pa;
  if (before.axis.spring_n_per_m == 0) asked.crosshead_velocity = before.axis.velocity_m_per_s;
  if (const auto reason = supervision.look(reading, seen, asked, apparatus->devices(), dt_s))
    go(Mode::safe, EventKind::safe_state, *reason);
}

/// One tick of the rig; false when the test cannot go on.
bool RigSoftware::Impl::tick(double dt_s) {
  if (mode != Mode::fallen) {
    act_as_operator();
    supervise(dt_s + late_s);
    before = demand(dt_s);
  }
  const Ticked done = apparatus->tick(before, {.stage = stage(),
                                               .time_s = time_s,
                                               .dt_s = dt_s,
                                               .running = mode == Mode::running,
                                               .readings = number + 1});
  if (mode == Mode::running) seen.add_stage_time(done.passed_s);
  time_s += done.passed_s;
  late_s = std::max(0.0, done.passed_s - dt_s);
  for (const std::string& warning : done.warnings) warn(warning);
  for (const Event& event : done.events) tell(event.kind, event.detail);
  if (done.end == Ticked::End::none) return true;
  done.end == Ticked::End::stopped ? warn(done.why) : cut(done.why);
  if (done.end == Ticked::End::lies_down) mode = Mode::fallen;
  if (done.end == Ticked::End::stopped) end_as(TestEnding::Kind::unfinished, done.why);
  return mode == Mode::fallen;
}

bool RigSoftware::Impl::advance_to_next_scan() {
  constexpr double kRoundOff_s = 1e-6;
  const double due = logger.due_s();
  const double interval = stage().logging.interval_s;
  const auto ticks = static_cast<int>(std::ceil(interval / kTick_s - 1e-9));
  for (int i = 0; i < ticks; ++i) {
    if (i > 0) {
      look();
      logger.add(reading);
    }
    if (!tick(interval / ticks)) return false;
    if (time_s > due - kRoundOff_s) break;
  }
  if (std::fabs(time_s - due) < kRoundOff_s) time_s = due;
  if (const auto report = missed.add(due, time_s, interval)) tell(EventKind::device_fault, *report);
  return true;
}

void RigSoftware::Impl::check_ranges() {
  for (std::size_t i = 0; i < kRawQuantityCount; ++i)
    if (const auto& row = quantities()[i]; apparatus->devices().saturated[i])
      if (!std::exchange(saturation_warned[i], true))
        warn(fmt::format("{} left its range of {:g} {} at {:.6g} s", row.name,
                         programme.transducers[i].range, row.unit, time_s));
}

RigSoftware::RigSoftware(const GuardedProgramme& programme, RecordHeader header,
                         std::unique_ptr<Apparatus> apparatus) {
  if (programme.programme.stages.empty())
    throw BadInput(programme.programme.source, 0, "the programme has no stage");
  impl_ = std::make_unique<Impl>(programme, std::move(header), std::move(apparatus));
}
RigSoftware::~RigSoftware() = default;

const RecordHeader& RigSoftware::header() const { return impl_->header; }

const Apparatus& RigSoftware::apparatus() const { return *impl_->apparatus; }
std::optional<Truth> RigSoftware::truth() const { return impl_->apparatus->truth(); }

std::vector<Check> RigSoftware::checks() const { return impl_->checks; }

std::vector<Event> RigSoftware::events() { return std::exchange(impl_->events, {}); }

bool RigSoftware::hold(const std::string& by) {
  return impl_->go(Impl::Mode::held, EventKind::held, by);
}
bool RigSoftware::resume(const std::string& by) {
  return impl_->go(Impl::Mode::running, EventKind::resumed, by);
}
bool RigSoftware::stop_safely(const std::string& by) {
  return impl_->go(Impl::Mode::safe, EventKind::aborted, by);
}
bool RigSoftware::abort(const std::string& reason) {
  const bool done = impl_->go(Impl::Mode::safe, EventKind::aborted, reason);
  impl_->apparatus->rest();
  return done;
}

void RigSoftware::heed(WarningLevel level) {
  impl_->guard.hear(level);
  impl_->act_as_guard_if_due();
}
const TestEnding& RigSoftware::ending() const { return impl_->ending; }
std::optional<std::string> RigSoftware::guarded() { return impl_->guard.take_news(); }

bool RigSoftware::next(Reading& reading) {
  Impl& rig = *impl_;
  if (rig.finished) return false;
  if (rig.number >= 0) {
    rig.finished = rig.stage_over() || !rig.advance_to_next_scan();
    if (rig.finished) {
      rig.apparatus->rest();
      return false;
    }
  }
  ++rig.number;
  rig.look();
  reading = rig.logger.record(rig.reading);
  if (rig.number == 0) rig.begin_stage();
  rig.check_ranges();
  if (rig.mode == Impl::Mode::safe || rig.mode == Impl::Mode::fallen) ++rig.safe_readings;
  return true;
}

double RigSoftware::progress() const {
  const Impl& rig = *impl_;
  if (rig.finished) return 1;
  return (static_cast<double>(rig.stage_index) + rig.progress.share(rig.stage(), rig.seen)) /
         static_cast<double>(rig.programme.stages.size());
}

}  // namespace triax::lab
