// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/virtual_rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/rig/axis_control.hpp"
#include "lab/rig/logger.hpp"
#include "lab/rig/rig_guard.hpp"
#include "lab/rig/rig_header.hpp"
#include "lab/rig/stage_progress.hpp"
#include "lab/rig/stage_words.hpp"
#include "lab/rig/strain_path_control.hpp"
#include "lab/rig/supervision.hpp"
#include "lab/rig/truth_log.hpp"

namespace triax::lab {
namespace {

Plant make_plant(const Programme& programme) {
  try {
    return Plant(programme);
  } catch (const std::invalid_argument& error) {
    throw BadInput(programme.source, 0, error.what());
  }
}

}  // namespace

struct VirtualRig::Impl {
  /// `fallen`: the cap lies on the stop after a run-away; the record goes on for some readings.
  enum class Mode { running, held, safe, fallen };

  Impl(const Programme& p, std::uint64_t used_seed)
      : Impl(p, with_guard_stages(as_far_as_simulated(p)), used_seed) {}
  Impl(const Programme& p, GuardedProgramme all, std::uint64_t used_seed)
      : guard(all),
        programme(std::move(all.programme)),
        header(rig_header(programme, used_seed)),
        plant(make_plant(programme)),
        instruments(programme, used_seed),
        logger(p.transducers),
        seen(header),
        supervision(programme),
        axis(AxisControl::Servo{.ideal = p.frame.bandwidth_hz == 0 && p.frame.moving_mass_kg == 0,
                                .filter_s = p.frame.servo_filter_s}),
        strain_path(p.specimen.height_m, p.frame.servo_filter_s),
        truth(plant.specimen().law()) {
    for (const auto& row : raw_channels())
      if (p.fitted[index(row.quantity)] && !programme.fitted[index(row.quantity)])
        warn(fmt::format("{} is not recorded: the virtual specimen does not have it", row.name));
  }

  const Stage& stage() const { return programme.stages[stage_index]; }
  void warn(const std::string& text) { header.warnings.push_back({0, text}); }
  /// The test ends here without having reached its end.
  void cut(const std::string& why) {
    warn(why);
    header.cut_short = why;
  }
  void warn_once(bool& done, const std::string& text) {
    if (!std::exchange(done, true)) warn(text);
  }
  void tell(EventKind kind, const std::string& detail) {
    events.push_back({.reading = number, .time_s = time_s, .kind = kind, .detail = detail});
  }

  void look();
  void begin_stage();
  bool met(const EndCondition& end) const;
  bool stage_over();
  void hold_by_guard(const std::string& detail);
  void act_as_guard_if_due();
  void act_as_operator();
  bool go(Mode next, EventKind kind, const std::string& detail);
  PlantDemand demand(double dt_s);
  void supervise(double dt_s);
  bool tick(double dt_s);
  bool within_travel(const sim::SpecimenStep& step);
  bool survived(const sim::SpecimenStep& step);
  bool advance_to_next_scan();
  void check_ranges();

  RigGuard guard;
  Programme programme;
  RecordHeader header;
  Plant plant;
  Instruments instruments;
  Logger logger;
  Seen seen;
  Supervision supervision;
  AxisControl axis;
  StrainPathControl strain_path;
  TruthLog truth;
  StageProgress progress;
  std::vector<Event> events;

  Reading reading;  ///< the latest look
  double time_s = 0;
  std::int64_t number = -1;  ///< of the last scan
  std::size_t stage_index = 0;
  Mode mode = Mode::running;
  int safe_readings = 0;
  std::size_t next_action = 0;
  std::optional<double> held_until_s;  ///< by the guard
  PlantDemand before;                  ///< of the last tick
  std::optional<double> shear_height;  ///< at the start of the first shear stage
  bool finished = false;
  std::array<bool, kRawQuantityCount> saturation_warned{};
  bool cavitation_warned = false, accuracy_warned = false;
};

void VirtualRig::Impl::look() {
  reading = Reading();
  reading.number = number;
  reading.time_s = time_s;
  const bool paused = mode == Mode::held || mode == Mode::safe;
  reading.stage = static_cast<int>(paused ? programme.stages.size() : stage_index) + 1;
  instruments.look(plant, time_s, reading);
  seen.take(reading);
}

void VirtualRig::Impl::begin_stage() {
  seen.begin_stage();
  const sim::SpecimenState& specimen = plant.state().specimen;
  axis.begin_stage(stage(), seen, plant.specimen().axial_force(specimen));
  strain_path.begin_stage(stage(), seen);
  supervision.begin_stage(stage());
  logger.begin(stage().logging, time_s);
  before = {};
  if (stage().role == StageRole::shear && !shear_height) {
    shear_height = specimen.height_m;
    for (const auto& outside :
         {void_ratio_outside(programme.material, specimen.material.void_ratio),
          p_eff_outside(programme.material, specimen.material.p())})
      if (outside) warn("at the start of shear " + *outside);
  }
  progress.begin_stage(seen);
}

/// A pressure that is the target of the stage's own ramp counts as reached when its controller has
/// come to it, whatever an offset of the transducer says.
bool VirtualRig::Impl::met(const EndCondition& end) const {
  const double bound = end.above.value_or(end.below.value_or(0));
  if (end.quantity == EndQuantity::cell_pressure && stage().cell.target_pa == bound)
    return end.met(plant.state().cell.asked_pa);
  if (end.quantity == EndQuantity::back_pressure && stage().back.target_pa == bound)
    return end.met(plant.state().back.asked_pa);
  // Its last value stands in for a channel that says nothing; no stage ends by that.
  return Supervision::can_tell(end.quantity, reading, instruments) && seen.met(end);
}

void VirtualRig::Impl::hold_by_guard(const std::string& detail) {
  go(Mode::held, EventKind::held, "by the guard: " + detail);
  held_until_s = time_s + guard.hold_s();
}

void VirtualRig::Impl::act_as_guard_if_due() {
  if (mode != Mode::running || !guard.is_due(stage_index, stage())) return;
  const Guard& now = guard.act();
  if (now.action == Guard::Action::safe) {
    go(Mode::safe, EventKind::safe_state, "by the guard");
    return;
  }
  cut(ended_by_guard(stage(), time_s, describe(now)));
  if (now.action == Guard::Action::hold) return hold_by_guard(describe(now));
  stage_index = guard.successor(stage_index);
  aim(now, seen, programme.specimen.height_m, programme.stages[stage_index]);
  begin_stage();
}

/// True where the stage is over and none follows, or it may not go on.
bool VirtualRig::Impl::stage_over() {
  if (mode == Mode::safe || mode == Mode::fallen) return safe_readings >= kSafeReadings;
  if (mode == Mode::held) return held_until_s && time_s >= *held_until_s;
  if (std::ranges::any_of(stage().end, [this](const auto& end) { return met(end); })) {
    if (guard.unloads()) {
      hold_by_guard("q was taken back");
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
  return true;
}

/// False where it stays as it is: a safe state is not left.
bool VirtualRig::Impl::go(Mode next, EventKind kind, const std::string& detail) {
  if (mode == next || mode == Mode::safe || mode == Mode::fallen) return false;
  const bool resumed = next == Mode::running;
  mode = next;
  tell(kind, detail);
  if (next == Mode::safe) cut(ended_in_safe_state(stage(), time_s, detail));
  if (resumed) held_until_s.reset();
  if (resumed) axis.resume(seen, plant.specimen().axial_force(plant.state().specimen));
  return true;
}

void VirtualRig::Impl::act_as_operator() {
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

PlantDemand VirtualRig::Impl::demand(double dt_s) {
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
  d.axis = axis.demand(seen, plant.next_cell_pa(d.cell, dt_s), dt_s);
  return d;
}

void VirtualRig::Impl::supervise(double dt_s) {
  for (const std::string& note : supervision.notes()) {
    warn(note);
    tell(EventKind::device_fault, note);
  }
  if (mode != Mode::running) return;
  Asked asked;
  asked.force_n = axis.wanted_force_n();
  asked.valve_open = before.valve_open;
  asked.back_by_volume = before.outflow_m3_per_s.has_value();
  asked.cell_pa = plant.state().cell.asked_pa;
  asked.back_pa = plant.state().back.asked_pa;
  if (before.axis.spring_n_per_m == 0) asked.crosshead_velocity = before.axis.velocity_m_per_s;
  if (const auto reason = supervision.look(reading, seen, asked, instruments, plant.state(), dt_s))
    go(Mode::safe, EventKind::safe_state, *reason);
}

/// False where the test cannot go on after this step.
bool VirtualRig::Impl::survived(const sim::SpecimenStep& step) {
  if (step.outcome == sim::StepOutcome::failed) {
    // A test that has readings is kept: the law may end where the specimen is liquefied.
    if (!step.law_ended || number <= 0)
      throw WorkFailed(fmt::format("{}: stage \"{}\" at {:.6g} s: {}", programme.source,
                                   stage().name, time_s, step.message));
    cut(ended_by_law(stage(), time_s, step));
    return false;
  }
  if (step.outcome == sim::StepOutcome::inaccurate)
    warn_once(accuracy_warned, fmt::format("from {:.6g} s on the integration of the law is less "
                                           "accurate than specified",
                                           time_s));
  if (step.outcome == sim::StepOutcome::lost_control) {
    cut(control_lost(stage(), time_s, step));
    return false;
  }
  if (step.state.pore_pressure < 0)
    warn_once(
        cavitation_warned,
        fmt::format("pore pressure below 0 from {:.6g} s on: cavitation is not modelled", time_s));
  return true;
}

/// One tick of the rig; false when the test cannot go on.
bool VirtualRig::Impl::tick(double dt_s) {
  if (mode == Mode::fallen) {
    time_s += dt_s;
    return true;
  }
  act_as_operator();
  supervise(dt_s);
  before = demand(dt_s);
  const sim::SpecimenState start = plant.state().specimen;
  const sim::SpecimenStep& step = plant.advance(before, time_s, dt_s);
  const TrueStep one{.time_s = time_s,
                     .dt_s = dt_s,
                     .before = start,
                     .step = step,
                     .sheared = stage().role == StageRole::shear && mode == Mode::running,
                     .height_at_shear_m = shear_height.value_or(programme.specimen.height_m)};
  if (step.outcome != sim::StepOutcome::failed) truth.add_work(one);
  if (!survived(step)) return false;
  time_s += dt_s;
  if (mode == Mode::running) seen.add_stage_time(dt_s);
  if (const std::string news = truth.add_run_away(one); !news.empty())
    tell(EventKind::run_away, news);
  return within_travel(step);
}

/// A crosshead stops at the end of its travel, and the test with it; a cap that fell there lies,
/// and what is left of the specimen, which is not moved on, is still read.
bool VirtualRig::Impl::within_travel(const sim::SpecimenStep& step) {
  constexpr double kRoundOff = 1 - 1e-9;
  const double travel = programme.frame.travel_m;
  const double displaced = programme.specimen.height_m - step.state.height_m;
  if (std::fabs(displaced) < travel * kRoundOff) return true;
  const bool dropped = step.at_stop && mode == Mode::running && fell(step.state);
  const std::string why = travel_reached(stage(), time_s, travel, displaced);
  dropped ? cut(why) : warn(why);
  if (dropped) mode = Mode::fallen;
  return dropped;
}

bool VirtualRig::Impl::advance_to_next_scan() {
  const double due = logger.due_s();
  const double interval = stage().logging.interval_s;
  const auto ticks = static_cast<int>(std::ceil(interval / kTick_s - 1e-9));
  for (int i = 0; i < ticks; ++i) {
    if (i > 0) {
      look();
      logger.add(reading);
    }
    if (!tick(interval / ticks)) return false;
  }
  time_s = due;
  return true;
}

void VirtualRig::Impl::check_ranges() {
  for (std::size_t i = 0; i < kRawQuantityCount; ++i)
    if (const auto& row = quantities()[i]; instruments.saturated(row.quantity))
      warn_once(saturation_warned[i],
                fmt::format("{} went out of its range of {:g} {} at {:.6g} s", row.name,
                            programme.transducers[i].range, row.unit, time_s));
}

VirtualRig::VirtualRig(const Programme& programme, std::optional<std::uint64_t> seed)
    : impl_(std::make_unique<Impl>(programme, seed.value_or(programme.seed))) {
  if (programme.stages.empty()) throw BadInput(programme.source, 0, "the programme has no stage");
}
VirtualRig::~VirtualRig() = default;

const RecordHeader& VirtualRig::header() const { return impl_->header; }
const sim::SpecimenState& VirtualRig::specimen_state() const {
  return impl_->plant.state().specimen;
}

const Plant& VirtualRig::plant() const { return impl_->plant; }

std::optional<Truth> VirtualRig::truth() const {
  return impl_->truth.truth(impl_->plant.state().specimen);
}

std::vector<Event> VirtualRig::events() { return std::exchange(impl_->events, {}); }

void VirtualRig::hold() { impl_->go(Impl::Mode::held, EventKind::held, "from outside"); }
void VirtualRig::resume() { impl_->go(Impl::Mode::running, EventKind::resumed, "from outside"); }
bool VirtualRig::abort(const std::string& reason) {
  return impl_->go(Impl::Mode::safe, EventKind::aborted, reason);
}

void VirtualRig::heed(WarningLevel level) {
  impl_->guard.hear(level);
  impl_->act_as_guard_if_due();
}
std::optional<std::string> VirtualRig::guarded() { return impl_->guard.take_news(); }

bool VirtualRig::next(Reading& reading) {
  Impl& rig = *impl_;
  if (rig.finished) return false;
  if (rig.number >= 0) {
    rig.finished = rig.stage_over() || !rig.advance_to_next_scan();
    if (rig.finished) return false;
  }
  ++rig.number;
  rig.look();
  reading = rig.logger.record(rig.reading);
  if (rig.number == 0) rig.begin_stage();
  rig.check_ranges();
  if (rig.mode == Impl::Mode::safe || rig.mode == Impl::Mode::fallen) ++rig.safe_readings;
  return true;
}

double VirtualRig::progress() const {
  const Impl& rig = *impl_;
  if (rig.finished) return 1;
  return (static_cast<double>(rig.stage_index) + rig.progress.share(rig.stage(), rig.seen)) /
         static_cast<double>(rig.programme.stages.size());
}

}  // namespace triax::lab
