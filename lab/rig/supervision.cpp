// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/supervision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "lab/devices/spoken_unit.hpp"
#include "lab/health/sensor_limits.hpp"

namespace triax::lab {
namespace {

using Channels = std::vector<Quantity>;

/// The channels from which the quantity of an end condition is made.
Channels channels_of(EndQuantity quantity) {
  using Q = Quantity;
  using enum EndQuantity;
  switch (quantity) {
    case time:
      return {};
    case cell_pressure:
      return {Q::cell_pressure};
    case back_pressure:
      return {Q::back_pressure};
    case pore_pressure:
      return {Q::pore_pressure};
    case pore_pressure_lag:
      return {Q::pore_pressure, Q::back_pressure};
    case b_value:
    case effective_radial_stress:
      return {Q::pore_pressure, Q::cell_pressure};
    case deviator_stress:
      return {Q::axial_force, Q::axial_displacement, Q::back_volume};
    case mean_effective_stress:
    case stress_ratio:
    case effective_axial_stress:
      return {Q::axial_force, Q::axial_displacement, Q::back_volume, Q::pore_pressure,
              Q::cell_pressure};
    case axial_strain:
    case axial_displacement:
    case axial_rate:
      return {Q::axial_displacement};
    case axial_force:
      return {Q::axial_force};
    case volumetric_strain:
    case void_ratio:
    case back_volume:
    case volume_rate:
      return {Q::back_volume};
  }
  return {};
}

/// What the axis' control loop reads.
Channels channels_of(const Stage& stage) {
  if (stage.strain_path_R) return {Quantity::axial_displacement, Quantity::back_volume};
  return way_of(stage.axial).looks_at;
}

std::string_view name_of(Quantity channel) { return info(channel).name; }

}  // namespace

Supervision::Supervision(const Programme& p)
    : fitted_(p.fitted),
      load_limit_n_(p.frame.load_limit_n),
      volume_m3_(std::numbers::pi / 4 * p.specimen.diameter_m * p.specimen.diameter_m *
                 p.specimen.height_m) {
  for (const auto& row : raw_channels())
    health_.emplace_back(finest_of(row.quantity), patience_of(row.quantity));
}

void Supervision::begin_stage(const Stage& stage) {
  stage_ = stage;
  needed_.fill(false);
  for (const Quantity channel : channels_of(stage)) needed_[index(channel)] = true;
  for (const EndCondition& end : stage.end)
    for (const Quantity channel : channels_of(end.quantity)) needed_[index(channel)] = true;
  force_off_s_ = cell_off_s_ = back_off_s_ = asked_way_ = 0;
  stood_ = 0;
  way_start_.reset();
  const bool drained = stage.role == StageRole::shear && stage.valve_open;
  for (std::size_t i = 0; i < kRawQuantityCount; ++i)
    health_[i].may_rest(quantities()[i].raw.counts_water && !drained);
}

bool Supervision::can_tell(EndQuantity quantity, const Reading& raw, const DeviceStates& devices) {
  return std::ranges::none_of(channels_of(quantity), [&](Quantity channel) {
    return std::isnan(raw[channel]) || devices.saturated[index(channel)];
  });
}

std::vector<std::string> Supervision::notes() { return std::exchange(notes_, {}); }

std::optional<std::string> Supervision::look(const Reading& raw, const Seen& seen,
                                             const Demanded& asked, const DeviceStates& devices,
                                             double dt_s) {
  const double force = seen[Quantity::axial_force];
  // Twice, so that a spike stops nothing.
  const bool above = load_limit_n_ > 0 && std::fabs(force) > load_limit_n_;
  if (above && std::exchange(above_limit_, above))
    return fmt::format(
        "emergency stop: the load of {:.1f} N exceeds the limit of the frame, {:g} N", force,
        load_limit_n_);
  above_limit_ = above;
  if (!devices.fault.empty()) return devices.fault;
  if (auto reason = full_or_empty(devices)) return reason;
  if (auto reason = deaf(raw, devices, dt_s)) return reason;
  if (auto reason = stuck(raw)) return reason;
  if (auto reason = astray(seen, asked, dt_s)) return reason;
  watch_closed_valve(seen, asked, dt_s);
  watch_open_valve(seen, asked, dt_s);
  watch_cell(seen, asked, dt_s);
  if (auto reason = force_astray(seen, asked, dt_s)) return reason;
  return standing(seen, asked, dt_s);
}

std::optional<std::string> Supervision::full_or_empty(const DeviceStates& devices) {
  for (const auto& [name, state] :
       {std::pair{"cell", &devices.cell}, std::pair{"back", &devices.back}})
    if (state->full || state->empty)
      return fmt::format("the {}-pressure controller is {}", name, state->full ? "full" : "empty");
  return std::nullopt;
}

std::optional<std::string> Supervision::deaf(const Reading& raw, const DeviceStates& devices,
                                             double dt_s) {
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) {
    if (!fitted_[i]) continue;
    const Quantity channel = quantities()[i].quantity;
    const bool missing = std::isnan(raw[channel]);
    if (!missing && !devices.saturated[index(channel)]) {
      silent_s_[i] = 0;
      told_[i] = false;
      continue;
    }
    silent_s_[i] += dt_s;
    // A servo would run after the end of the range: twice is enough.
    const bool misleads = !missing && by_force(stage_.axial) && channel == Quantity::axial_force;
    if (silent_s_[i] < (misleads ? 1.5 * dt_s : kDeaf_s)) continue;
    const std::string what = fmt::format(
        "{} {}", name_of(channel), missing ? "gives no readings" : "is at the end of its range");
    if (needs(channel)) return what;
    if (!std::exchange(told_[i], true))
      notes_.push_back(fmt::format("{} from {:.6g} s on", what, raw.time_s - silent_s_[i] + dt_s));
  }
  return std::nullopt;
}

double Supervision::allowed_difference_pa(double asked_pa) {
  return std::max(5e3, 0.02 * std::fabs(asked_pa));
}

std::optional<std::string> Supervision::astray(const Seen& seen, const Demanded& asked,
                                               double dt_s) {
  struct Loop {
    const char* name;
    double seen, asked;
    double& off_s;
    bool active;
  };
  for (const Loop& loop :
       {Loop{"cell", seen[Quantity::cell_pressure], asked.cell_pa, cell_off_s_, true},
        Loop{"back", seen[Quantity::back_pressure], asked.back_pa, back_off_s_,
             !asked.back_by_volume}}) {
    const bool off =
        loop.active && std::fabs(loop.seen - loop.asked) > allowed_difference_pa(loop.asked);
    loop.off_s = off ? loop.off_s + dt_s : 0;
    if (loop.off_s >= kAstray_s)
      return fmt::format("the {} pressure reads {:.1f} kPa instead of the {:.1f} kPa prescribed",
                         loop.name, loop.seen / 1e3, loop.asked / 1e3);
  }
  return std::nullopt;
}

std::optional<std::string> Supervision::stuck(const Reading& raw) {
  ++looks_;
  std::optional<std::string> reason;
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) {
    if (!fitted_[i]) continue;
    const Quantity channel = quantities()[i].quantity;
    health_[i].add(looks_, raw[channel]);
    const auto& dead = health_[i].dead();
    if (!dead || !needs(channel) || dead->fault == SensorFault::missing) continue;
    const sim::Unit unit = spoken_unit(channel);
    reason = fmt::format("{} was at exactly {:g} {}: stuck, because a working transducer has noise",
                         name_of(channel), sim::to_field(raw[channel], unit), unit.name);
  }
  return reason;
}

std::optional<std::string> Supervision::force_astray(const Seen& seen, const Demanded& asked,
                                                     double dt_s) {
  if (!asked.force_n) return std::nullopt;
  const double displacement = seen[Quantity::axial_displacement];
  const double missing = std::fabs(*asked.force_n - seen[Quantity::axial_force]);
  const bool off = missing > std::max(10.0, 0.05 * std::fabs(*asked.force_n));
  if (!off || !force_off_at_) force_off_at_ = displacement;
  force_off_s_ = off ? force_off_s_ + dt_s : 0;
  const bool stands = std::fabs(displacement - *force_off_at_) < 0.2e-3;
  if (force_off_s_ < kAstray_s / 4 || !stands) return std::nullopt;
  return fmt::format(
      "the load cell reads {:.1f} N instead of the {:.1f} N prescribed, and the cap does not move",
      seen[Quantity::axial_force], *asked.force_n);
}

std::optional<std::string> Supervision::standing(const Seen& seen, const Demanded& asked,
                                                 double dt_s) {
  constexpr double kWay_m = 0.25e-3;
  const double displacement = seen[Quantity::axial_displacement];
  if (!way_start_) way_start_ = displacement;
  asked_way_ += asked.crosshead_velocity * dt_s;
  if (std::fabs(asked_way_) <= kWay_m) return std::nullopt;
  const double way = displacement - *way_start_;
  const bool stood = std::fabs(way) < 0.1 * std::fabs(asked_way_);
  stood_ = stood ? stood_ + 1 : 0;
  const double asked_way = std::exchange(asked_way_, 0);
  way_start_ = displacement;
  if (stood_ < 2) return std::nullopt;
  return fmt::format(
      "the crosshead moved by {:.3f} mm, but the displacement reading changed by {:.3f} mm",
      asked_way * 1e3, way * 1e3);
}

void Supervision::RestingVolume::moves(double volume) {
  last = {last[1], last[2], volume};
  off_s = 0;
  told = false;
}

std::optional<double> Supervision::RestingVolume::rests(double volume, double allowed,
                                                        double dt_s) {
  for (double& value : last)
    if (std::isnan(value)) value = volume;
  const double start =
      std::max(std::min(last[0], last[1]), std::min(std::max(last[0], last[1]), last[2]));
  off_s = std::fabs(volume - start) > allowed ? off_s + dt_s : 0;
  if (told || off_s < kDeaf_s) return std::nullopt;
  told = true;
  return volume - start;
}

void Supervision::watch_closed_valve(const Seen& seen, const Demanded& asked, double dt_s) {
  const double volume = seen[Quantity::back_volume];
  if (asked.valve_open) return back_water_.moves(volume);
  if (const auto flowed =
          back_water_.rests(volume, sensor_limits::kClosedVolume * volume_m3_, dt_s))
    notes_.push_back(
        fmt::format("water flows although the valve is closed ({:.0f} mm3 since then): the valve "
                    "does not close, or there is a leak",
                    *flowed * 1e9));
}

void Supervision::watch_cell(const Seen& seen, const Demanded& asked, double dt_s) {
  constexpr double kShare = 4e-3;  // of the specimen's volume; a membrane takes some of it
  const double volume = seen[Quantity::cell_volume];
  const bool ramps = std::exchange(cell_held_pa_, asked.cell_pa) != asked.cell_pa;
  if (asked.valve_open || ramps) return cell_water_.moves(volume);
  if (const auto flowed = cell_water_.rests(volume, kShare * volume_m3_, dt_s))
    notes_.push_back(
        fmt::format("water flows into the cell although its pressure and the volume of the "
                    "specimen are constant ({:.0f} mm3 meanwhile): cell or controller leaks",
                    *flowed * 1e9));
}

void Supervision::watch_open_valve(const Seen& seen, const Demanded& asked, double dt_s) {
  constexpr double kLag_pa = 10e3, kShare = 2e-5;
  const double volume = seen[Quantity::back_volume];
  const double lag = seen[Quantity::pore_pressure] - seen[Quantity::back_pressure];
  const bool flows = std::fabs(volume - no_flow_volume_) > kShare * volume_m3_;
  if (!asked.valve_open || flows || std::fabs(lag) < kLag_pa) {
    no_flow_s_ = 0;
    no_flow_volume_ = volume;
    return;
  }
  no_flow_s_ += dt_s;
  if (no_flow_s_ < kAstray_s || std::exchange(no_flow_told_, true)) return;
  notes_.push_back(fmt::format(
      "the valve is open and the pore pressure differs by {:.1f} kPa from the back pressure, but "
      "no water flows: the valve does not open, or one of the transducers is wrong",
      lag / 1e3));
}

}  // namespace triax::lab
