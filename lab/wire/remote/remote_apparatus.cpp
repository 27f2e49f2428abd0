// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/remote_apparatus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/rig/rig_software.hpp"
#include "lab/rig/stage_words.hpp"
#include "lab/rig/supervision.hpp"
#include "lab/wire/device_modes.hpp"
#include "lab/wire/remote/control_line.hpp"
#include "lab/wire/remote/drive_settings.hpp"

namespace triax::lab {
namespace {

/// What is read of a drive beside its channels.
std::vector<std::string> states_of(const RigInstrument& one) {
  if (one.role == RigRole::frame) return {"state", "piston_force_N"};
  if (one.role == RigRole::reads) return {};
  return {"set_point_kPa", "piston", "watchdog"};
}

void check_complete(const RigFile& rig, const Programme& programme) {
  std::string missing;
  for (const RigRole role : {RigRole::frame, RigRole::cell, RigRole::back})
    if (!rig.with(role))
      missing += fmt::format(", an instrument with role = \"{}\"", to_text(role));
  for (const auto& row : raw_channels())
    if (programme.fitted[index(row.quantity)] && !rig.channel(row.quantity))
      missing += fmt::format(", a channel for {}", row.name);
  if (!missing.empty()) throw BadInput(rig.file, 0, "missing in the rig: " + missing.substr(2));
}

/// A frame that cannot go on, as a tick ends with it.
Ticked::End end_of(FrameState state) {
  if (state == FrameState::on_stop) return Ticked::End::lies_down;
  if (state == FrameState::end_of_travel) return Ticked::End::stopped;
  return state == FrameState::cannot_follow ? Ticked::End::cut : Ticked::End::none;
}

}  // namespace

RemoteApparatus::RemoteApparatus(LineLoop& loop, const RigFile& rig, const Programme& programme,
                                 std::function<bool()> stop)
    : loop_(loop),
      rig_(rig),
      programme_(programme),
      stop_(std::move(stop)),
      instruments_(loop, rig, states_of) {
  check_complete(rig, programme);
}

RemoteApparatus::~RemoteApparatus() { RemoteApparatus::rest(); }

void RemoteApparatus::await(const std::function<bool()>& done, double within_s) {
  loop_.run_until([&] { return done() || (stop_ && stop_()); }, loop_.now_s() + within_s);
}

void RemoteApparatus::connect(double within_s) {
  const std::string missing = instruments_.connect(within_s, stop_);
  if (!missing.empty())
    throw WorkFailed(fmt::format("{}: not all instruments responded{}", rig_.file, missing));
  if (rig_.plant && rig_.plant->control) {
    control_ = std::make_unique<ControlLine>(loop_, *rig_.plant->control);
    time_ = control_->ask_time();
  }
  clocks_ = InstrumentClocks(time_.speed);
}

/// Of an instant on the loop's clock; in lock step that of the reading, since none passes between.
double RemoteApparatus::test_time_s(double loop_s, const Reading& reading) const {
  return time_.lock_step ? reading.time_s : loop_s * time_.speed;
}

void RemoteApparatus::take(const WireInstrument& one, const WireInstrument::Scan& scan,
                           Reading& reading) {
  absences_.take(one, scan.why);
  if (scan.why.empty()) heard_s_[&one] = loop_.now_s();
  if (scan.stamp_s)
    clocks_.take(one.described().name, *scan.stamp_s, test_time_s(scan.sent_s, reading),
                 test_time_s(scan.answered_s, reading));
  const std::vector<RigChannel>& channels = one.described().channels;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (!channels[i].quantity) continue;
    const std::size_t place = index(*channels[i].quantity);
    double si = scan.channels[i].value * channels[i].scale;
    if (channels[i].from_start && !std::isnan(si))
      si -= starts_.try_emplace(*channels[i].quantity, si).first->second;
    reading[*channels[i].quantity] = si;
    const double end = end_of_range_si(programme_.transducers[place]);
    const bool at_end = std::fabs(si) >= std::fabs(end) * (1 - 1e-9);
    devices_.saturated[place] = !scan.channels[i].in_range || at_end;
  }
  if (reading.has(Quantity::axial_displacement))
    displaced_m_ = reading[Quantity::axial_displacement];
  take_states(one.described().role, scan.also);
}

/// What a drive does not say it is taken to be as before.
void RemoteApparatus::take_states(RigRole role, const std::vector<double>& said) {
  if (role == RigRole::reads) return;
  if (role == RigRole::frame) {
    if (!std::isnan(said[0])) frame_state_ = static_cast<FrameState>(static_cast<int>(said[0]));
    if (!std::isnan(said[1])) devices_.piston_force_n = said[1];
    if (frame_state_ == FrameState::emergency_stop)
      devices_.fault = "emergency stop: reported by the frame";
    if (frame_state_ == FrameState::watchdog)
      devices_.fault = "the watchdog stopped the frame: no command received for too long";
    return;
  }
  auto& one = role == RigRole::cell ? devices_.cell : devices_.back;
  // The digits of the wire are fewer than those of a ramp that ends at its target exactly.
  constexpr double kDigits = 1e-6;
  const double asked_pa = said[0] * 1e3;
  if (std::fabs(asked_pa - one.asked_pa) > kDigits * std::max(1e3, asked_pa))
    one.asked_pa = asked_pa;
  if (!std::isnan(said[1])) {
    one.full = said[1] == 1;
    one.empty = said[1] == 2;
  }
  if (said[2] == 1)
    devices_.fault =
        fmt::format("the watchdog of the {}-pressure controller holds the pressure", to_text(role));
}

void RemoteApparatus::look(Reading& reading) {
  devices_.fault.clear();
  for (const auto& [role, times] : refusals_)
    if (times >= kRefusals)
      devices_.fault = fmt::format("{} rejects commands: {}",
                                   instruments_.with(role)->described().name, refused_);
  const double nominal_s = reading.time_s;
  const double asked_s = instruments_.scan(
      [this, &reading](const WireInstrument& one, const WireInstrument::Scan& scan) {
        take(one, scan, reading);
      },
      [this](const WireInstrument& one) { return awaited_until_s(one); });
  const double stall_s = loop_.take_longest_stall_s();
  if (start_s_) look_for_stall(stall_s);
  if (!start_s_) start_s_ = asked_s - nominal_s / time_.speed;
  look_for_deaf_drives();
  if (!time_.lock_step) reading.time_s = (asked_s - *start_s_) * time_.speed;
}

/// A program that stands still neither reads nor controls: it counts as a channel that is silent.
/// The limit is on the clock of this machine, as those of the watchdogs are: a rig that runs 60
/// times faster than the clock passes 3 s of its test in every delay of 0.05 s.
void RemoteApparatus::look_for_stall(double stall_s) {
  if (time_.lock_step || stall_s < Supervision::kDeaf_s || !devices_.fault.empty()) return;
  devices_.fault = fmt::format(
      "this program was suspended for {:.1f} s: no readings and no control during this time",
      stall_s);
}

/// An instrument whose deadline is long is not waited for beyond the time after which it is deaf:
/// then it is asked with little patience, so that the rig gets safe in time.
double RemoteApparatus::awaited_until_s(const WireInstrument& one) const {
  const auto heard = heard_s_.find(&one);
  if (heard == heard_s_.end()) return std::numeric_limits<double>::infinity();
  return std::max(heard->second + Supervision::kDeaf_s / time_.speed,
                  loop_.now_s() + RigSoftware::kTick_s);
}

/// One that cannot be told what to do may do anything, whoever else measures it.
void RemoteApparatus::look_for_deaf_drives() {
  for (const RigRole role : {RigRole::frame, RigRole::cell, RigRole::back}) {
    const WireInstrument& one = *instruments_.with(role);
    const std::string& why = absences_.why(one);
    const double since_s = std::max(heard_s_[&one], *start_s_);
    if (why.empty() || (loop_.now_s() - since_s) * time_.speed < Supervision::kDeaf_s) continue;
    devices_.fault = fmt::format("{} sent no valid response for {:g} s: {}", one.described().name,
                                 Supervision::kDeaf_s, why);
  }
}

void RemoteApparatus::drive(RigRole role, const DriveSettings& settings) {
  WireInstrument& one = *instruments_.with(role);
  Sent& sent = sent_[role];
  const bool changed = sent.link != one.links() || sent.settings != settings;
  if (!changed || !one.ready()) return;
  sent = {one.links(), settings};
  ++orders_;
  one.set(settings, [this, role, &one](const std::string& why) {
    --orders_;
    refusals_[role] = why.empty() ? 0 : refusals_[role] + 1;
    if (why.empty()) return;
    sent_.erase(role);
    refused_ = why;
    absences_.take(one, why);
  });
}

/// Time that passes until the tick is over.
double RemoteApparatus::pass(const Tick& tick) {
  if (time_.lock_step) {
    frame_state_ = control_->step(tick.dt_s);
    return tick.dt_s;
  }
  const double end_s = *start_s_ + (tick.time_s + tick.dt_s) / time_.speed;
  await([] { return false; }, end_s - loop_.now_s());
  // A little lateness is made good at the next tick, more than one is time that has gone by.
  const double late_s = (loop_.now_s() - end_s) * time_.speed;
  return late_s > tick.dt_s ? tick.dt_s + late_s : tick.dt_s;
}

Ticked RemoteApparatus::tick(const PlantDemand& demand, const Tick& tick) {
  drive(RigRole::back, back_settings(demand));
  drive(RigRole::cell, pressure_settings(demand.cell));
  drive(RigRole::frame, frame_settings(demand.axis, tick.dt_s));
  await([this] { return orders_ == 0; }, kOrderPatience_s);
  Ticked done;
  done.passed_s = pass(tick);
  follow_ramps(demand, done.passed_s);
  for (std::string& news : clocks_.news())
    done.events.push_back({.kind = EventKind::device_fault, .detail = std::move(news)});
  for (std::string& news : absences_.news((loop_.now_s() - *start_s_) * time_.speed))
    done.events.push_back({.kind = EventKind::device_fault, .detail = std::move(news)});
  end_by_state(tick, done);
  return done;
}

/// Where the set points are by now, until they are read.
void RemoteApparatus::follow_ramps(const PlantDemand& demand, double dt_s) {
  double &cell_pa = devices_.cell.asked_pa, &back_pa = devices_.back.asked_pa;
  cell_pa = process(programme_.cell_controller, cell_pa, demand.cell, dt_s);
  back_pa = process(programme_.back_controller, back_pa, demand.back, dt_s);
}

void RemoteApparatus::end_by_state(const Tick& tick, Ticked& done) {
  const Ticked::End end = end_of(frame_state_);
  if (end == std::exchange(told_end_, end)) return;
  done.end = end;
  const double time_s = tick.time_s + done.passed_s;
  if (end == Ticked::End::cut) {
    done.passed_s = 0;
    done.why = fmt::format(
        "stage \"{}\" ended at {:.6g} s: the frame reported that the specimen cannot follow the "
        "prescribed path",
        tick.stage.name, tick.time_s);
  } else {
    done.why = travel_reached(tick.stage, time_s, programme_.frame.travel_m, displaced_m_);
  }
}

void RemoteApparatus::rest() {
  drive(RigRole::frame, stopped_frame());
  for (const RigRole role : {RigRole::cell, RigRole::back}) drive(role, held_pressure());
  loop_.run_until([this] { return orders_ == 0; }, loop_.now_s() + kOrderPatience_s);
}

}  // namespace triax::lab
