#include "lab/rig/supervision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

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
  using Q = Quantity;
  if (stage.strain_path_R) return {Q::axial_displacement, Q::back_volume};
  switch (stage.axial) {
    case AxialAction::load:
      return {Q::axial_force};
    case AxialAction::constant_q:
      return {Q::axial_force, Q::axial_displacement, Q::back_volume};
    case AxialAction::stress_ratio:
      return {Q::axial_force, Q::axial_displacement, Q::back_volume, Q::pore_pressure};
    default:
      return {};
  }
}

std::string_view name_of(Quantity channel) { return info(channel).name; }

}  // namespace

Supervision::Supervision(const Programme& p)
    : load_limit_n_(p.frame.load_limit_n),
      volume_m3_(std::numbers::pi / 4 * p.specimen.diameter_m * p.specimen.diameter_m *
                 p.specimen.height_m) {}

void Supervision::begin_stage(const Stage& stage) {
  stage_ = stage;
  needed_.fill(false);
  for (const Quantity channel : channels_of(stage)) needed_[index(channel)] = true;
  for (const EndCondition& end : stage.end)
    for (const Quantity channel : channels_of(end.quantity)) needed_[index(channel)] = true;
  force_off_s_ = cell_off_s_ = back_off_s_ = asked_way_ = 0;
  way_start_.reset();
  volume_start_.reset();
}

std::vector<std::string> Supervision::notes() { return std::exchange(notes_, {}); }

std::optional<std::string> Supervision::look(const Reading& raw, const Seen& seen,
                                             const Asked& asked, const Instruments& instruments,
                                             const PlantState& devices, double dt_s) {
  const double force = seen[Quantity::axial_force];
  // Twice, so that a spike stops nothing.
  const bool above = load_limit_n_ > 0 && std::fabs(force) > load_limit_n_;
  if (above && std::exchange(above_limit_, above))
    return fmt::format("emergency stop: the load of {:.1f} N is above the frame's limit of {:g} N",
                       force, load_limit_n_);
  above_limit_ = above;
  if (auto reason = full_or_empty(devices)) return reason;
  if (auto reason = deaf(raw, instruments, dt_s)) return reason;
  if (auto reason = astray(seen, asked, dt_s)) return reason;
  watch_valve(seen, asked);
  return standing(seen, asked, dt_s);
}

std::optional<std::string> Supervision::full_or_empty(const PlantState& devices) const {
  for (const auto& [name, state] :
       {std::pair{"cell", &devices.cell}, std::pair{"back", &devices.back}})
    if (state->full || state->empty)
      return fmt::format("the {}-pressure controller is {}", name, state->full ? "full" : "empty");
  return std::nullopt;
}

std::optional<std::string> Supervision::deaf(const Reading& raw, const Instruments& instruments,
                                             double dt_s) {
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) {
    const Quantity channel = quantities()[i].quantity;
    const bool missing = std::isnan(raw[channel]);
    if (!missing && !instruments.saturated(channel)) {
      silent_s_[i] = 0;
      told_[i] = false;
      continue;
    }
    silent_s_[i] += dt_s;
    if (silent_s_[i] < kDeaf_s) continue;
    const std::string what =
        fmt::format("{} {}", name_of(channel),
                    missing ? "gives no readings" : "stands at the end of its range");
    if (needs(channel)) return what;
    if (!std::exchange(told_[i], true))
      notes_.push_back(fmt::format("{} from {:.6g} s on", what, raw.time_s - silent_s_[i] + dt_s));
  }
  return std::nullopt;
}

std::optional<std::string> Supervision::astray(const Seen& seen, const Asked& asked, double dt_s) {
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
    const double allowed = std::max(5e3, 0.02 * std::fabs(loop.asked));
    const bool off = loop.active && std::fabs(loop.seen - loop.asked) > allowed;
    loop.off_s = off ? loop.off_s + dt_s : 0;
    if (loop.off_s >= kAstray_s)
      return fmt::format("the {} pressure reads {:.1f} kPa where {:.1f} kPa were asked for",
                         loop.name, loop.seen / 1e3, loop.asked / 1e3);
  }
  return std::nullopt;
}

std::optional<std::string> Supervision::standing(const Seen& seen, const Asked& asked,
                                                 double dt_s) {
  const double displacement = seen[Quantity::axial_displacement];
  if (asked.force_n) {
    const double missing = std::fabs(*asked.force_n - seen[Quantity::axial_force]);
    const bool off = missing > std::max(10.0, 0.05 * std::fabs(*asked.force_n));
    if (!off || !force_off_at_) force_off_at_ = displacement;
    force_off_s_ = off ? force_off_s_ + dt_s : 0;
    const bool stands = std::fabs(displacement - *force_off_at_) < 0.2e-3;
    if (force_off_s_ >= kAstray_s / 4 && stands)
      return fmt::format(
          "the load cell reads {:.1f} N where {:.1f} N were asked for, and the cap "
          "stands",
          seen[Quantity::axial_force], *asked.force_n);
  }
  if (!way_start_) way_start_ = displacement;
  asked_way_ += asked.crosshead_velocity * dt_s;
  const double way = displacement - *way_start_;
  if (std::fabs(asked_way_) > 0.5e-3 && std::fabs(way) < 0.1 * std::fabs(asked_way_))
    return fmt::format("the crosshead was moved by {:.3f} mm, the displacement reads {:.3f} mm",
                       asked_way_ * 1e3, way * 1e3);
  return std::nullopt;
}

void Supervision::watch_valve(const Seen& seen, const Asked& asked) {
  constexpr double kShare = 5e-4;  // of the specimen's volume
  const double volume = seen[Quantity::back_volume];
  if (asked.valve_open || !volume_start_) {
    volume_start_ = volume;
    valve_told_ = valve_told_ && !asked.valve_open;
    return;
  }
  if (valve_told_ || std::fabs(volume - *volume_start_) < kShare * volume_m3_) return;
  valve_told_ = true;
  notes_.push_back(
      fmt::format("water flows although the valve is closed ({:.0f} mm3 since it was): "
                  "it does not close, or there is a leak",
                  (volume - *volume_start_) * 1e9));
}

}  // namespace triax::lab
