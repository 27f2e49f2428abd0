#include "lab/health/record_health.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace triax::lab {
namespace {

/// A controller may hold its pressure, and a piston its place, quieter than the noise so far.
double patience_of(Quantity q) {
  switch (q) {
    case Quantity::cell_pressure:
    case Quantity::back_pressure:
    case Quantity::back_volume:
    case Quantity::cell_volume:
      return 2;
    default:
      return 1;
  }
}

bool may_be_compared(Quantity q) {
  return q == Quantity::axial_force || q == Quantity::axial_displacement ||
         q == Quantity::pore_pressure;
}

}  // namespace

RecordHealth::RecordHealth(const RecordHeader& header) : header_(header) {
  for (Quantity q : header.columns)
    if (!header.is_raw() || is_raw(q))
      channels_.push_back({.quantity = q, .health = ChannelHealth(patience_of(q)), .open = {}});
}

void RecordHealth::start_stage(const Reading& reading) {
  stage_ = reading.stage;
  stage_from_ = reading.number;
  const StageInfo* info = header_.stage(reading.stage);
  shear_ = info && info->role == StageRole::shear;
  driven_ = shear_ && info->control == AxialControl::displacement;
}

void RecordHealth::watch(const Reading& reading) {
  wrong_.clear();
  news_.clear();
  if (!stage_ || *stage_ != reading.stage) start_stage(reading);
  for (Channel& channel : channels_) {
    channel.health.add(reading.number, reading[channel.quantity]);
    if (channel.health.run() == 0) channel.at_rest = reading;
  }
  note_jumps(reading);
  doubtful_from_ = reading.number + 1;
  for (Channel& channel : channels_) {
    if (header_.is_raw() && shear_ && may_be_compared(channel.quantity)) compare(channel, reading);
    report(channel, reading);
    if (const auto doubt = channel.health.doubtful_from())
      doubtful_from_ = std::min(doubtful_from_, *doubt);
  }
  last_ = reading;
}

void RecordHealth::note_jumps(const Reading& reading) {
  const auto jumped = [&](const Channel& c) { return c.health.jumped_at() == reading.number; };
  if (std::ranges::count_if(channels_, jumped) != 1) return;
  std::ranges::find_if(channels_, jumped)->lonely_jump = reading.number;
}

bool RecordHealth::jumped_alone(const Channel& channel) const {
  const auto jump = channel.health.jumped_at();
  return jump && jump == channel.lonely_jump && *jump > stage_from_ &&
         (driven_ || channel.quantity == Quantity::pore_pressure);
}

void RecordHealth::compare(Channel& channel, const Reading& reading) {
  ChannelHealth& health = channel.health;
  if (health.dead() || health.run() == 0 || health.run() > ChannelNoise::kLongestWait) return;
  if (jumped_alone(channel) && health.run() >= ChannelHealth::kFlat) {
    health.condemn();
    return;
  }
  if (!driven_ || channel.quantity == Quantity::pore_pressure || health.run_from() <= stage_from_)
    return;
  doubtful_from_ = std::min(doubtful_from_, health.run_from());
  if (health.run() >= kAtRest && cannot_rest(channel, reading)) health.condemn();
}

bool RecordHealth::cannot_rest(const Channel& channel, const Reading& reading) const {
  const auto& specimen = header_.specimen;
  if (!specimen.height_m || !specimen.diameter_m) return false;
  const double step = channel.health.noise().step();
  if (!(step > 0)) return false;
  const auto change = [&](Quantity q) { return std::fabs(reading[q] - channel.at_rest[q]); };
  if (channel.quantity == Quantity::axial_force) {
    const double strain = change(Quantity::axial_displacement) / *specimen.height_m;
    return std::fabs(channel.health.value()) * strain > kSteps * step;
  }
  const double area = std::numbers::pi / 4 * *specimen.diameter_m * *specimen.diameter_m;
  const double strain = change(Quantity::axial_force) / area / kStiffest_pa;
  return strain * *specimen.height_m > kLeastSteps * step;
}

std::optional<double> RecordHealth::time_of(std::int64_t number, const Reading& now) const {
  if (!header_.has_time || std::isnan(now.time_s)) return std::nullopt;
  if (number == now.number || std::isnan(last_.time_s)) return now.time_s;
  // Readings of the last few hundred are not kept: the scan's interval leads back to it.
  const double interval = now.time_s - last_.time_s;
  return now.time_s - interval * static_cast<double>(now.number - number);
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
    channel.open = SensorFinding{q, fault, from, time_of(from, reading), {}, health.value()};
    tally(*channel.open);
    wrong_.push_back({*channel.open, from, reading.number});
  } else if (channel.open) {
    wrong_.push_back({*channel.open, reading.number, reading.number});
  } else if (health.absent()) {
    wrong_.push_back(
        {{q, SensorFault::missing, reading.number, {}, {}, 0}, reading.number, reading.number});
  }
  if (const auto& spike = health.spike()) {
    const SensorFinding finding{
        q,           SensorFault::spike, spike->from, time_of(spike->from, reading), spike->until,
        spike->value};
    tally(finding);
    wrong_.push_back({finding, spike->from, spike->until});
  }
}

std::vector<Warning> RecordHealth::warnings() const {
  std::vector<Warning> all;
  for (const auto& [first, more] : tallies_) {
    std::string text = describe(first);
    if (more > 0) text += fmt::format(", and {} more time{}", more, more == 1 ? "" : "s");
    all.push_back({0, std::move(text)});
  }
  return all;
}

}  // namespace triax::lab
