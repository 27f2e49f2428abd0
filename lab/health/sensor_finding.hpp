// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What can be seen to be wrong with a sensor from its own readings.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/results/quantity.hpp"

namespace triax::lab {

/// missing    no reading, where there had been one at every scan
/// saturated  a jump out of all that was read before, to one constant value: open circuit, overload
/// stuck      one constant value for longer than the sensor's own noise allows
/// spike      up to three readings, or a longer run of one value, that leave the level before and
///            after them, which is the same: a spike or a dropout
enum class SensorFault { missing, saturated, stuck, spike };
std::string_view to_string(SensorFault fault);

struct SensorFinding {
  Quantity channel{};
  SensorFault fault{};
  std::int64_t from = 0;              ///< first reading that is wrong
  std::optional<double> from_time_s;  ///< empty where the record has no time
  /// Last wrong reading; empty while it lasts. Always known for a spike.
  std::optional<std::int64_t> until;
  double value_si = 0;  ///< what was read there; meaningless for `missing`
};

/// The sensor as people call it: "the load cell (axial_force)".
std::string sensor_name(Quantity channel);
/// "the load cell (axial_force) is stuck at 0.1234 kN from reading 230 (460 s) on".
std::string describe(const SensorFinding& finding);
/// The same in short, as a reason: "the load cell (axial_force) is stuck".
std::string reason(const SensorFinding& finding);
/// The end of a warning about a channel that someone says is sound.
inline constexpr std::string_view kBelievedThough = "; used because the user confirmed it (=sound)";
/// Someone says that the channel is sound, and it gives values to believe.
bool is_vouched(const SensorFinding& finding, const std::vector<Quantity>& vouched);

}  // namespace triax::lab
