// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Watches over a running test as the software of a real rig does: from readings, from what the
// devices say of themselves and from what was asked of them. Whatever a control loop or the end of
// the stage depends on must be alive; else the rig goes to its safe state. What only the record
// needs is reported, and the test goes on.
//
// Looked for:
// - a transducer without a reading, or at the end of its range, for kDeaf_s;
// - a channel that a loop or the end needs and that stands still as noise never would;
// - a force that stays away from that of servo or masses although the cap stands (in a collapse it
//   moves);
// - a pressure that stays away from what its controller was asked for;
// - a crosshead that was asked to move and a displacement that does not, twice in a row;
// - a device that says of itself that it failed; a controller that is full or empty; a load above
// the frame's limit (emergency stop); and, only reported:
// - water that flows from or to the back controller although the valve is closed, or that the cell
//   takes although valve and pressures rest;
// - a pore pressure away from the back pressure and no water that flows although the valve is open.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lab/health/channel_health.hpp"
#include "lab/programmes/programme.hpp"
#include "lab/rig/device_states.hpp"
#include "lab/rig/seen.hpp"

namespace triax::lab {

/// What the rig asked for at a look, beside what it then saw.
struct Demanded {
  std::optional<double> force_n;    ///< of servo or masses, as the load cell is to read it
  double crosshead_velocity = 0;    ///< m/s; only where nothing lies between crosshead and cap
  double cell_pa = 0, back_pa = 0;  ///< set points
  bool back_by_volume = false;
  bool valve_open = true;
};

class Supervision {
 public:
  static constexpr double kDeaf_s = 3;     ///< a channel may be silent for so long
  static constexpr double kAstray_s = 60;  ///< a controlled quantity may be off for so long

  /// By how much a pressure may read other than its set point, Pa.
  static double allowed_difference_pa(double asked_pa);

  explicit Supervision(const Programme& programme);

  void begin_stage(const Stage& stage);
  /// The reason for the safe state; empty while the test may go on. `raw` may hold gaps.
  std::optional<std::string> look(const Reading& raw, const Seen& seen, const Demanded& asked,
                                  const DeviceStates& devices, double dt_s);
  /// Whether the channels behind the quantity give readings within their ranges.
  static bool can_tell(EndQuantity quantity, const Reading& raw, const DeviceStates& devices);
  /// What was noticed since the last call and does not stop the test.
  std::vector<std::string> notes();

 private:
  bool needs(Quantity channel) const { return needed_[index(channel)]; }
  std::optional<std::string> deaf(const Reading& raw, const DeviceStates& devices, double dt_s);
  static std::optional<std::string> full_or_empty(const DeviceStates& devices);
  std::optional<std::string> astray(const Seen& seen, const Demanded& asked, double dt_s);
  std::optional<std::string> stuck(const Reading& raw);
  std::optional<std::string> force_astray(const Seen& seen, const Demanded& asked, double dt_s);
  std::optional<std::string> standing(const Seen& seen, const Demanded& asked, double dt_s);
  void watch_closed_valve(const Seen& seen, const Demanded& asked, double dt_s);
  void watch_open_valve(const Seen& seen, const Demanded& asked, double dt_s);
  void watch_cell(const Seen& seen, const Demanded& asked, double dt_s);

  /// A counter of water, that stays away from where it rested for kDeaf_s.
  struct RestingVolume {
    std::array<double, 3> last{kMissing, kMissing, kMissing};  ///< before it had to rest
    double off_s = 0;
    bool told = false;
    void moves(double volume);
    /// By how much it moved, once that is more than `allowed` and not only for an instant.
    std::optional<double> rests(double volume, double allowed, double dt_s);
  };

  FittedChannels fitted_;
  double load_limit_n_, volume_m3_;
  Stage stage_;
  std::array<bool, kRawQuantityCount> needed_{};
  std::array<double, kRawQuantityCount> silent_s_{};  ///< since when a channel says nothing
  std::array<bool, kRawQuantityCount> told_{};
  std::vector<ChannelHealth> health_;  ///< one a channel
  std::int64_t looks_ = 0;
  double force_off_s_ = 0, cell_off_s_ = 0, back_off_s_ = 0;
  double asked_way_ = 0;  ///< of the crosshead since way_start_, m
  int stood_ = 0;         ///< times in a row that the displacement did not follow
  std::optional<double> way_start_, force_off_at_;
  RestingVolume back_water_, cell_water_;
  double cell_held_pa_ = kMissing;  ///< set point at the last look
  double no_flow_s_ = 0, no_flow_volume_ = 0;
  bool no_flow_told_ = false, above_limit_ = false;
  std::vector<std::string> notes_;
};

}  // namespace triax::lab
