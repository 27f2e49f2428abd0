// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace triax::lab {

/// What can be made to go wrong with a simulated device.
enum class FaultKind {
  stuck,         ///< a channel repeats its last value; a controller's piston, the frame stand still
  open_circuit,  ///< a channel reads the end of its range
  spike,         ///< single readings of a channel are off by ± size
  drop_out,      ///< a channel gives no readings
  drift,         ///< a channel's zero runs away at `size` per second
  latency,       ///< a channel's readings come `size` seconds late
  full,          ///< a controller takes no more water
  empty,         ///< a controller gives no more water
  leak,          ///< a controller loses `size` · pressure
  does_not_close,  ///< the valve stays open
  does_not_open,   ///< the valve stays closed
};

/// A fault, SI. Where it has no meaning (see possible_faults) it does nothing.
struct Fault {
  std::string device;  ///< a raw channel ("pore_pressure"), or one of the other fault_devices()
  FaultKind kind = FaultKind::stuck;
  double from_s = 0;              ///< test time, included
  std::optional<double> until_s;  ///< test time, not included; for good without it
  double size = 0;  ///< spike: > 0; drift: per s, either sign; latency: s; leak: m³/(s Pa)
  bool active(double time_s) const { return time_s >= from_s && (!until_s || time_s < *until_s); }
  bool operator==(const Fault&) const = default;
};

/// "stuck", "open_circuit"...: as programmes write it.
std::string_view to_string(FaultKind kind);

/// The raw channels, "cell_controller", "back_controller", "frame" and "valve".
const std::vector<std::string>& fault_devices();

/// The kinds that have a meaning for that device; none for a name that is no device.
std::span<const FaultKind> possible_faults(std::string_view device);

/// In words for record and report, with the unit of the field: "simulated fault: pore_pressure
/// drift of 2 kPa/min from 3600 s to 4000 s".
std::string describe(const Fault& fault);

/// Those of one device that are active at that test time, in their order.
std::vector<Fault> active_faults(const std::vector<Fault>& faults, std::string_view device,
                                 double time_s);

/// Whether one of that kind is among them.
bool holds(const std::vector<Fault>& faults, FaultKind kind);

}  // namespace triax::lab
