// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/record_health.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "lab/health/sensor_limits.hpp"
#include "lab/measured/assessment_limits.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::lab {
namespace {

namespace limits = sensor_limits;

}  // namespace

RecordHealth::RecordHealth(const RecordHeader& header) : header_(header), raw_(header.is_raw()) {
  const auto& specimen = header.specimen;
  if (specimen.diameter_m)
    area_m2_ = std::numbers::pi / 4 * *specimen.diameter_m * *specimen.diameter_m;
  volume_m3_ = area_m2_ * specimen.height_m.value_or(0);
  for (Quantity q : header.columns)
    if (!header.is_raw() || is_raw(q))
      channels_.push_back({.quantity = q,
                           .health = ChannelHealth(finest_of(q), patience_of(q), worth_of(q),
                                                   header.is_foreign() && info(q).raw.held),
                           .open = {}});
}

void RecordHealth::start_stage(const Reading& reading) {
  stage_ = reading.stage;
  stage_from_ = reading.number;
  const StageInfo* info = header_.stage(reading.stage);
  shear_ = info && info->role == StageRole::shear;
  driven_ = shear_ && info->control == AxialControl::displacement;
  const bool was_drained = drained_;
  path_flow_.reset();
  if (shear_ && info->strain_path_R) path_flow_ = std::fabs(1 - 1 / *info->strain_path_R);
  drained_ =
      shear_ && info->drainage == Drainage::open && path_flow_.value_or(1) > limits::kPathFlow;
  fell_ = false;
  closed_ = info && info->drainage == Drainage::closed;
  open_ = info && info->drainage == Drainage::open;
  held_ = info && info->role == StageRole::hold;
  for (Channel& channel : channels_) {
    if (!was_drained || channel.quantity != Quantity::back_volume)
      channel.moves = channel.longest_run = 0;
    // What a piston counts moves with the water, not with noise, and rests while the valve is shut.
    channel.health.may_rest(lab::info(channel.quantity).raw.counts_water && !drained_);
    channel.at_rest = now_;
  }
}

bool RecordHealth::is_compared(Quantity q) const {
  if (!raw_) return false;
  if (q == Quantity::back_volume) return true;
  if (!shear_) return false;
  if (q == Quantity::axial_force || q == Quantity::axial_displacement) return driven_;
  return q == Quantity::pore_pressure;
}

void RecordHealth::watch(const Reading& reading) {
  wrong_.clear();
  news_.clear();
  std::copy_n(reading.si.begin(), now_.size(), now_.begin());
  latest_ = reading.number;
  times_[static_cast<std::size_t>(reading.number) % kTimes] = reading.time_s;
  if (!stage_ || *stage_ != reading.stage) start_stage(reading);
  note_fall(reading);
  for (Channel& channel : channels_) {
    const std::int64_t run = channel.health.run();
    if (channel.quantity == Quantity::volumetric_strain)
      channel.health.may_rest(water_is_shut_in(channel));
    if (channel.quantity == Quantity::pore_pressure && header_.is_foreign())
      channel.health.may_rest(is_held_through_valve(channel));
    channel.health.add(reading.number, reading[channel.quantity]);
    channel.stirred = run >= limits::kStuckAfterJump.count() && channel.health.run() == 0;
    if (channel.health.run() > 0) continue;
    channel.at_rest = now_;
    ++channel.moves;
    channel.longest_run = std::max(channel.longest_run, run);
  }
  note_jumps(reading);
  doubtful_from_ = reading.number + 1;
  for (Channel& channel : channels_) {
    if (is_compared(channel.quantity)) compare(channel, reading);
    report(channel, reading);
    doubtful_from_ = std::min(doubtful_from_, channel.health.doubtful_from());
  }
}

/// A reduced record seldom says that the valve was shut; the pore pressure, which moves then, does.
bool RecordHealth::water_is_shut_in(const Channel& channel) const {
  constexpr std::size_t kPore = index(Quantity::pore_pressure);
  return std::fabs(now_[kPore] - channel.at_rest[kPore]) >
         std::max<double>(limits::kShutWater, limits::kNoises * noise_of(Quantity::pore_pressure));
}

/// Through an open valve the pore pressure is the back pressure, and is held as long as that is.
bool RecordHealth::is_held_through_valve(const Channel& channel) const {
  constexpr std::size_t kBack = index(Quantity::back_pressure);
  return open_ && !(std::fabs(now_[kBack] - channel.at_rest[kBack]) >
                    std::max<double>(limits::kShutWater,
                                     limits::kNoises * noise_of(Quantity::back_pressure)));
}

void RecordHealth::note_fall(const Reading& reading) {
  const double now = reading[Quantity::axial_displacement];
  const double way = std::fabs(now - std::exchange(displacement_, now));
  fell_ = fell_ || (!driven_ && way > assessment_limits::kLeap * volume_m3_ / area_m2_);
}

void RecordHealth::note_jumps(const Reading& reading) {
  const auto jumped = [&](const Channel& c) {
    return c.stirred || c.health.jumped_at() == reading.number;
  };
  if (std::ranges::count_if(channels_, jumped) != 1) return;
  std::ranges::find_if(channels_, jumped)->lonely_jump = reading.number;
}

bool RecordHealth::jumped(const Channel& channel) const {
  const auto jump = channel.health.jumped_at();
  if (!jump || channel.health.run() < limits::kStuckAfterJump.count()) return false;
  // A rig that is held goes on from the stage before without a break.
  if (*jump <= stage_from_ - (held_ ? limits::kStuckAfterJump.count() : 0)) return false;
  const bool alone = jump == channel.lonely_jump;
  if (channel.quantity != Quantity::back_volume) return alone;
  const double height = channel.health.jump_height();
  return height > limits::kImpossibleJump * volume_m3_ ||
         (height > limits::kVolumeJump * volume_m3_ && (alone || closed_));
}

std::int64_t RecordHealth::rest(const Channel& channel, const Reading& reading) const {
  if (channel.health.run() == 0) return 0;
  return reading.number - std::max(channel.health.run_from() - 1, stage_from_);
}

void RecordHealth::compare(Channel& channel, const Reading& reading) {
  ChannelHealth& health = channel.health;
  const std::int64_t at_rest = rest(channel, reading);
  if (health.dead() || at_rest == 0 || !(volume_m3_ > 0)) return;
  if (at_rest > kLongestRest) {
    // Too late to hold states back: what rested on it is taken back.
    const bool stopped = channel.quantity == Quantity::back_volume && drained_ && !fell_ &&
                         channel.moves >= limits::kStuck.count() && outlasts(channel, reading);
    if (stopped) health.condemn();
    return;
  }
  if (jumped(channel)) {
    health.condemn();
    return;
  }
  bool waited = at_rest >= limits::kStuck.count();
  if (channel.quantity == Quantity::pore_pressure) return;
  if (channel.quantity == Quantity::back_volume) {
    if (!drained_ || fell_) return;
    if (channel.moves == 0 && waited && never_moves(channel, reading)) return health.condemn();
    if (channel.moves < limits::kStuck.count()) return;
    const auto longest = static_cast<double>(std::max<std::int64_t>(channel.longest_run, 1));
    const auto run = static_cast<double>(at_rest);
    waited = waited && (run >= limits::kLongRest * longest || runs_away(channel, reading));
  }
  doubtful_from_ = std::min(doubtful_from_, health.run_from());
  if (waited && cannot_rest(channel, reading)) health.condemn();
}

bool RecordHealth::sound(std::initializer_list<Quantity> quantities) const {
  return std::ranges::none_of(channels_, [&](const Channel& c) {
    return std::ranges::find(quantities, c.quantity) != quantities.end() &&
           (c.health.dead() || c.health.doubtful_from() != ChannelHealth::kNever);
  });
}

bool RecordHealth::runs_away(const Channel& channel, const Reading& reading) const {
  const double height = volume_m3_ / area_m2_;
  const double way =
      reading[Quantity::axial_displacement] - channel.at_rest[index(Quantity::axial_displacement)];
  return !driven_ && sound({Quantity::axial_displacement}) &&
         std::fabs(way) > limits::kRunningStrain * height;
}

/// At rest while p′ changed by more than a volume can stand still for.
bool RecordHealth::outlasts(const Channel& channel, const Reading& reading) const {
  const double before = p_eff(channel.at_rest);
  return std::fabs(p_eff(now_) - before) > limits::kLargeChangeOfP * before &&
         cannot_rest(channel, reading);
}

/// A counter that moved before shear and in drained shear not once, whatever p′ does.
bool RecordHealth::never_moves(const Channel& channel, const Reading& reading) const {
  return channel.health.noise().moves() >= limits::kStuck.count() && outlasts(channel, reading);
}

bool RecordHealth::loads_up(const Channel& channel, const Reading& reading) const {
  const double before = std::fabs(channel.at_rest[index(Quantity::axial_force)]);
  const double gain = std::fabs(reading[Quantity::axial_force]) - before;
  const auto longest = static_cast<double>(std::max<std::int64_t>(channel.longest_run, 1));
  return channel.moves >= limits::kStuck.count() && gain > limits::kGainOfLoad * before &&
         gain > limits::kNoises * noise_of(Quantity::axial_force) &&
         static_cast<double>(rest(channel, reading)) >= limits::kVeryLongRest * longest;
}

bool RecordHealth::cannot_rest(const Channel& channel, const Reading& reading) const {
  const double step = channel.health.noise().step();
  if (!(step > 0)) return false;
  const auto change = [&](Quantity q) {
    return std::fabs(now_[index(q)] - channel.at_rest[index(q)]);
  };
  const double height = volume_m3_ / area_m2_;
  if (channel.quantity == Quantity::axial_force) {
    const double strain = change(Quantity::axial_displacement) / height;
    return sound({Quantity::axial_displacement}) &&
           std::fabs(channel.health.value()) * strain > limits::kSteps * step;
  }
  if (channel.quantity == Quantity::axial_displacement) {
    if (!sound({Quantity::axial_force})) return false;
    const double strain = change(Quantity::axial_force) / area_m2_ / limits::kStiffest;
    return strain * height > limits::kMinSteps * step || loads_up(channel, reading);
  }
  const double strain = change(Quantity::axial_displacement) / height;
  if (path_flow_ && !(*path_flow_ * strain * volume_m3_ > limits::kSteps * step)) return false;
  if (runs_away(channel, reading)) return true;
  const double before = p_eff(channel.at_rest);
  const double share = std::fabs(p_eff(now_) - before) / before;
  return sound({Quantity::axial_force, Quantity::cell_pressure, Quantity::pore_pressure}) &&
         before > 0 && share > limits::kChangeOfP && share * before > limits::kNoises * p_noise() &&
         share / limits::kStiffestBulk * volume_m3_ > limits::kMinSteps * step;
}

double RecordHealth::p_eff(const RawValues& values) const {
  const auto value = [&](Quantity q) { return values[index(q)]; };
  const double strain = or_zero(value(Quantity::axial_displacement)) * area_m2_ / volume_m3_;
  return value(Quantity::cell_pressure) - value(Quantity::pore_pressure) +
         value(Quantity::axial_force) * (1 - strain) / area_m2_ / 3;
}

double RecordHealth::noise_of(Quantity quantity) const {
  const auto channel = std::ranges::find(channels_, quantity, &Channel::quantity);
  return channel == channels_.end() ? 0 : channel->health.noise().roughness();
}

double RecordHealth::p_noise() const {
  return noise_of(Quantity::axial_force) / area_m2_ / 3 + noise_of(Quantity::cell_pressure) +
         noise_of(Quantity::pore_pressure);
}

std::optional<double> RecordHealth::time_of(std::int64_t number) const {
  const double time = times_[static_cast<std::size_t>(number) % kTimes];
  const bool kept = latest_ - number < static_cast<std::int64_t>(kTimes);
  if (!header_.has_time || !kept || std::isnan(time)) return std::nullopt;
  return time;
}

SensorFinding& RecordHealth::tally(const SensorFinding& finding) {
  news_.push_back(finding);
  for (Tally& t : tallies_) {
    if (t.first.channel != finding.channel || t.first.fault != finding.fault) continue;
    ++t.more;
    return t.first;
  }
  return tallies_.emplace_back(Tally{finding}).first;
}

void RecordHealth::report(Channel& channel, const Reading& reading) {
  const ChannelHealth& health = channel.health;
  const Quantity q = channel.quantity;
  if (channel.open && !health.dead()) {
    for (Tally& t : tallies_)
      if (t.first.channel == q && t.first.fault == channel.open->fault &&
          t.first.from == channel.open->from)
        t.first.until = reading.number - 1;
    channel.open.reset();
  }
  if (health.dead() && !channel.open) {
    const auto& [fault, from] = *health.dead();
    channel.open = SensorFinding{q, fault, from, time_of(from), {}, health.value()};
    tally(*channel.open);
    wrong_.push_back({*channel.open, from, reading.number});
  } else if (channel.open) {
    wrong_.push_back({*channel.open, reading.number, reading.number});
  } else if (health.absent()) {
    wrong_.push_back(
        {{q, SensorFault::missing, reading.number, {}, {}, 0}, reading.number, reading.number});
  }
  if (channel.health.spike()) report_spike(channel);
}

void RecordHealth::report_spike(const Channel& channel) {
  const auto& spike = channel.health.spike();
  const auto leaped_too = [&](const Channel& other) {
    return &other != &channel && other.health.leaped_at(spike->leap);
  };
  if (!spike->certain && std::ranges::any_of(channels_, leaped_too)) return;
  const SensorFinding finding{channel.quantity,     SensorFault::spike, spike->from,
                              time_of(spike->from), spike->until,       spike->value};
  tally(finding);
  wrong_.push_back({finding, spike->from, spike->until});
}

void RecordHealth::finish() {
  wrong_.clear();
  news_.clear();
  for (Channel& channel : channels_) {
    channel.health.finish(latest_);
    if (channel.health.spike()) report_spike(channel);
  }
}

std::vector<Warning> RecordHealth::warnings() const {
  std::vector<Warning> all;
  for (const auto& [first, more] : tallies_) {
    std::string text = describe(first);
    if (more > 0) text += fmt::format(", and {} more time{}", more, more == 1 ? "" : "s");
    if (is_vouched(first, header_.vouched))
      text += kBelievedThough;
    else if (header_.origin == Origin::recorded && first.fault == SensorFault::stuck)
      text += fmt::format("; if the sensor is not faulty: --set sensors.{}=sound",
                          info(first.channel).name);
    all.push_back({0, std::move(text)});
  }
  return all;
}

}  // namespace triax::lab
