// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/served/served_devices.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "lab/devices/spoken_unit.hpp"

namespace triax::lab {
namespace {

constexpr double kMmPerMinute = 1e-3 / 60;
constexpr double kKiloPascalPerMinute = 1e3 / 60;
constexpr double kAnything = std::numeric_limits<double>::max();

struct Limits {
  double low = -kAnything, high = kAnything;  ///< SI
};

/// A set point that stands in `member`, SI, and is in force once the mode is set.
Point set_point(const std::string& name, double scale, Limits limits, double& member) {
  return {.name = name,
          .read = [&member, scale] { return member / scale; },
          .write =
              [&member, scale, limits, name](double value) {
                const double si = value * scale;
                if (std::isfinite(si) && si >= limits.low && si <= limits.high) {
                  member = si;
                  return;
                }
                throw Refused(Refused::Why::out_of_range,
                              fmt::format("{} must be {:g} to {:g}", name, limits.low / scale,
                                          limits.high / scale));
              }};
}

/// A whole number from 0 to count − 1.
int number_below(int count, double value, std::string_view name) {
  const int number = value >= 0 && value < count ? static_cast<int>(value) : -1;
  if (number != value)
    throw Refused(Refused::Why::out_of_range, fmt::format("{} must be 0 to {}", name, count - 1));
  return number;
}

Point said(std::string name, std::function<double()> read) {
  return {.name = std::move(name), .read = std::move(read), .write = {}};
}

Point watchdog_limit(Watchdog& watchdog) {
  return set_point("watchdog_s", 1, {0, 3600}, watchdog.limit_s);
}

}  // namespace

std::function<double()> channel_of(const ServedPlant& plant, Quantity channel) {
  return [&plant, channel, unit = spoken_unit(channel)] {
    const double si = plant.reading()[channel];
    return std::isnan(si) ? si : sim::to_field(si, unit);
  };
}

ServedDrives::ServedDrives(ServedPlant& plant, double watchdog_s, ClockSeconds clock)
    : plant_(plant),
      clock_(std::move(clock)),
      frame_watchdog_(watchdog_s),
      cell_{.asked = {}, .watchdog = Watchdog(watchdog_s), .order = &ServedPlant::order_cell},
      back_{.asked = {}, .watchdog = Watchdog(watchdog_s), .order = &ServedPlant::order_back} {}

WireDevice ServedDrives::frame() {
  const LoadingFrame& limits = plant_.programme().frame;
  const double load =
      limits.load_limit_n > 0 ? limits.load_limit_n : std::numeric_limits<double>::max();
  FrameSettings& f = frame_;
  WireDevice device{.name = "frame",
                    .identity = fmt::format("triax,loading frame,{},1", kSimulatedWord),
                    .points = {},
                    .heard = [this] { frame_watchdog_.heard(clock_(), client_); },
                    .reset = [this] { frame_ = {}; }};
  const Limits speed{-limits.fastest_m_per_s, limits.fastest_m_per_s}, force{-load, load};
  device.points = {
      said("displacement_mm", channel_of(plant_, Quantity::axial_displacement)),
      said("force_N", channel_of(plant_, Quantity::axial_force)),
      said("piston_force_N", [this] { return plant_.devices().piston_force_n; }),
      said("state", [this] { return static_cast<double>(frame_state()); }),
      set_point("velocity_mm_per_min", kMmPerMinute, speed, f.velocity_m_per_s),
      set_point("spring_N_per_mm", 1e3, {0, kAnything}, f.spring_n_per_m),
      set_point("force_from_N", 1, force, f.force_from_n),
      set_point("force_to_N", 1, force, f.force_to_n),
      set_point("force_time_s", 1, {0, 1e9}, f.force_time_s),
      set_point("area_mm2", 1e-6, {0, kAnything}, f.area_m2),
      set_point("stress_from_kPa", 1e3, {}, f.stress_from_pa),
      set_point("stress_to_kPa", 1e3, {}, f.stress_to_pa),
      set_point("impulse_N_s", 1, {}, f.impulse_n_s),
      {.name = "perturbed",
       .read = [&f] { return f.perturbed ? 1.0 : 0.0; },
       .write = [&f](double value) { f.perturbed = number_below(2, value, "perturbed") == 1; }},
      watchdog_limit(frame_watchdog_),
      {.name = "mode",
       .read = [this] { return static_cast<double>(plant_.axis().mode); },
       .write =
           [this](double value) {
             frame_.mode = static_cast<FrameMode>(number_below(kFrameModes, value, "mode"));
             frame_watchdog_.ordered(clock_(), client_);
             plant_.order_axis(frame_);
           }}};
  return device;
}

FrameState ServedDrives::frame_state() const {
  if (plant_.frame_state() != FrameState::ready) return plant_.frame_state();
  return frame_watchdog_.bitten() ? FrameState::watchdog : FrameState::ready;
}

WireDevice ServedDrives::controller(Controller& one, const PressureController& limits,
                                    const DeviceStates::Controller& of_it, Quantity pressure,
                                    Quantity volume) {
  ControllerSettings& s = one.asked;
  const double fastest = limits.rate_limit_pa_per_s;
  WireDevice device{.name = {},
                    .identity = fmt::format("triax,pressure controller,{} {},1", kSimulatedWord,
                                            pressure == Quantity::cell_pressure ? "cell" : "back"),
                    .points = {},
                    .heard = [this, &one] { one.watchdog.heard(clock_(), client_); },
                    .reset = [&s] { s = {}; }};
  device.points = {
      said("pressure_kPa", channel_of(plant_, pressure)),
      said("volume_mm3", channel_of(plant_, volume)),
      said("set_point_kPa", [&of_it] { return of_it.asked_pa / 1e3; }),
      said("piston", [&of_it] { return of_it.full    ? 1.0
                                       : of_it.empty ? 2.0
                                                     : 0.0; }),
      said("watchdog", [&one] { return one.watchdog.bitten() ? 1.0 : 0.0; }),
      set_point("target_kPa", 1e3, {0, limits.range_pa}, s.target_pa),
      set_point("rate_kPa_per_min", kKiloPascalPerMinute, {-fastest, fastest}, s.rate_pa_per_s),
      set_point("flow_mm3_per_s", 1e-9, {}, s.flow_m3_per_s),
      watchdog_limit(one.watchdog),
      {.name = "mode",
       .read = [&s] { return static_cast<double>(s.mode); },
       .write =
           [this, &one](double value) {
             one.asked.mode =
                 static_cast<ControllerMode>(number_below(kControllerModes, value, "mode"));
             one.watchdog.ordered(clock_(), client_);
             (plant_.*one.order)(one.asked);
           }}};
  return device;
}

WireDevice ServedDrives::cell_controller() {
  return controller(cell_, plant_.programme().cell_controller, plant_.devices().cell,
                    Quantity::cell_pressure, Quantity::cell_volume);
}

WireDevice ServedDrives::back_controller() {
  WireDevice device = controller(back_, plant_.programme().back_controller, plant_.devices().back,
                                 Quantity::back_pressure, Quantity::back_volume);
  device.points.push_back(
      {.name = "valve_open",
       .read = [this] { return plant_.valve_open() ? 1.0 : 0.0; },
       .write = [this](double v) { plant_.open_valve(number_below(2, v, "valve_open") == 1); }});
  return device;
}

void ServedDrives::watch() {
  const double now_s = clock_();
  if (frame_watchdog_.look(now_s)) plant_.order_axis({});
  for (Controller* one : {&cell_, &back_})
    if (one->watchdog.look(now_s)) (plant_.*one->order)({});
}

}  // namespace triax::lab
