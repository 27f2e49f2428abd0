// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The virtual rig behind instruments on the wire: the plant under what its frame, controllers and
// valve were ordered to do, moved on tick by tick, looked at once a tick by its transducers. No
// socket and no clock: whoever drives it says how much time passes.
#include <optional>
#include <string>
#include <vector>

#include "lab/rig/simulated/virtual_apparatus.hpp"
#include "lab/wire/served/axis_orders.hpp"

namespace triax::lab {

/// The set points of a controller, SI.
struct ControllerSettings {
  ControllerMode mode = ControllerMode::hold;
  double target_pa = 0;
  double rate_pa_per_s = 0;  ///< of any sign
  double flow_m3_per_s = 0;  ///< out of the specimen
};

class ServedPlant {
 public:
  /// The stages of the programme do not matter. Throws BadInput as VirtualApparatus does.
  ServedPlant(const Programme& programme, std::uint64_t seed);

  const Programme& programme() const { return programme_; }
  std::uint64_t seed() const { return seed_; }
  double time_s() const { return time_s_; }
  /// What the transducers said at the last look; SI, NaN: nothing.
  const Reading& reading() const { return reading_; }
  const DeviceStates& devices() const { return apparatus_.devices(); }
  FrameState frame_state() const { return frame_state_; }
  /// Why it stands, in words; empty while it can go on.
  const std::string& stands_because() const { return why_; }

  /// Orders hold until the next one. `cell`, `back`: in force from the next tick on.
  void order_axis(const FrameSettings& settings);
  void order_cell(const ControllerSettings& settings) { cell_ = settings; }
  void order_back(const ControllerSettings& settings) { back_ = settings; }
  void open_valve(bool open) { valve_open_ = open; }
  bool valve_open() const { return valve_open_; }
  const FrameSettings& axis() const { return axis_.settings(); }

  /// Moves on by dt > 0 and looks. Where the specimen cannot follow it stands, and time goes on.
  void tick(double dt_s);
  /// Switches a fault of docs/reference/sensor-faults.md on from now on; one without a meaning does
  /// nothing.
  void add_fault(Fault fault);
  void clear_faults();
  const std::vector<Fault>& faults() const { return programme_.faults; }

 private:
  void look();

  Programme programme_;
  std::uint64_t seed_;
  VirtualApparatus apparatus_;
  Stage stage_;  ///< what the apparatus is told of the programme: nothing
  AxisOrders axis_;
  ControllerSettings cell_, back_;
  bool valve_open_ = true;
  double time_s_ = 0;
  std::int64_t ticks_ = 0;
  Reading reading_;
  FrameState frame_state_ = FrameState::ready;
  std::string why_;
};

}  // namespace triax::lab
