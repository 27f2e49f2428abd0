// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The devices of a virtual rig as they stand on the wire: named values over one plant. The names
// are those of the personalities triax-frame and triax-controller.
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "lab/wire/served/served_plant.hpp"
#include "lab/wire/wire_device.hpp"

namespace triax::lab {

/// Seconds on a clock that never goes back, for watchdogs.
using ClockSeconds = std::function<double()>;

/// A device that holds what it drives once its controller has been silent for `watchdog_s` (0: it
/// never does). Its controller is the client that ordered last: what others ask keeps nothing
/// awake. It is told of time by look(); the next order wakes it.
class Watchdog {
 public:
  explicit Watchdog(double watchdog_s) : limit_s(watchdog_s) {}
  void heard(double now_s, int client) {
    if (!controller_ || *controller_ == client) heard_s_ = now_s;
  }
  void ordered(double now_s, int client) {
    controller_ = client;
    heard_s_ = now_s;
    bitten_ = false;
  }
  /// True at the look at which it bites.
  bool look(double now_s) {
    const bool late = limit_s > 0 && heard_s_ && now_s - *heard_s_ > limit_s;
    return late && !std::exchange(bitten_, true);
  }
  bool bitten() const { return bitten_; }

  double limit_s;

 private:
  std::optional<int> controller_;
  std::optional<double> heard_s_;
  bool bitten_ = false;
};

/// The three devices that drive a served plant, which must outlive them.
class ServedDrives {
 public:
  ServedDrives(ServedPlant& plant, double watchdog_s, ClockSeconds clock);

  WireDevice frame();
  WireDevice cell_controller();
  /// With the drainage valve behind it.
  WireDevice back_controller();

  /// What is asked and ordered from now on comes from this client.
  void speaks(int client) { client_ = client; }
  int new_client() { return ++clients_; }
  /// Lets the watchdogs look: a device whose controller is silent stops, or holds.
  void watch();

 private:
  struct Controller {
    ControllerSettings asked;
    Watchdog watchdog;
    void (ServedPlant::*order)(const ControllerSettings&);
  };
  FrameState frame_state() const;
  WireDevice controller(Controller& one, const PressureController& limits,
                        const DeviceStates::Controller& of_it, Quantity pressure, Quantity volume);

  ServedPlant& plant_;
  ClockSeconds clock_;
  int client_ = 0, clients_ = 0;
  FrameSettings frame_;
  Watchdog frame_watchdog_;
  Controller cell_, back_;
};

/// What the transducer of that raw channel says, in its unit of the field.
std::function<double()> channel_of(const ServedPlant& plant, Quantity channel);

}  // namespace triax::lab
