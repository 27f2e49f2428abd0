#pragma once
// Watches over a running test as the software of a real rig does: from readings, from what the
// devices say of themselves and from what was asked of them. Whatever a control loop or the end of
// the stage depends on must be alive; else the rig goes to its safe state. What only the record
// needs is reported, and the test goes on.
//
// Looked for, beyond what the channels' health tells:
//   a transducer without a reading, or at the end of its range, for kDeaf_s
//   a force that stays away from what the servo wants although the cap stands: in a collapse it
//   moves a pressure that stays away from what its controller was asked for a crosshead that was
//   asked to move and a displacement that does not a controller that is full or empty; a load above
//   the frame's limit (emergency stop) water that flows although the valve is closed (reported)
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lab/rig/instruments.hpp"
#include "lab/rig/seen.hpp"

namespace triax::lab {

/// What the rig asked for at a look, beside what it then saw.
struct Asked {
  std::optional<double> force_n;    ///< that the servo follows
  double crosshead_velocity = 0;    ///< m/s; only where nothing lies between crosshead and cap
  double cell_pa = 0, back_pa = 0;  ///< set points
  bool back_by_volume = false;
  bool valve_open = true;
};

class Supervision {
 public:
  static constexpr double kDeaf_s = 3;     ///< a channel may be silent for so long
  static constexpr double kAstray_s = 60;  ///< a controlled quantity may be off for so long

  explicit Supervision(const Programme& programme);

  void begin_stage(const Stage& stage);
  /// The reason for the safe state; empty while the test may go on. `raw` may hold gaps.
  std::optional<std::string> look(const Reading& raw, const Seen& seen, const Asked& asked,
                                  const Instruments& instruments, const PlantState& devices,
                                  double dt_s);
  /// What was noticed since the last call and does not stop the test.
  std::vector<std::string> notes();

 private:
  bool needs(Quantity channel) const { return needed_[index(channel)]; }
  std::optional<std::string> deaf(const Reading& raw, const Instruments& instruments, double dt_s);
  std::optional<std::string> full_or_empty(const PlantState& devices) const;
  std::optional<std::string> astray(const Seen& seen, const Asked& asked, double dt_s);
  std::optional<std::string> standing(const Seen& seen, const Asked& asked, double dt_s);
  void watch_valve(const Seen& seen, const Asked& asked);

  double load_limit_n_, volume_m3_;
  Stage stage_;
  std::array<bool, kRawQuantityCount> needed_{};
  std::array<double, kRawQuantityCount> silent_s_{};  ///< since when a channel says nothing
  std::array<bool, kRawQuantityCount> told_{};
  double force_off_s_ = 0, cell_off_s_ = 0, back_off_s_ = 0;
  double asked_way_ = 0;  ///< of the crosshead since the stage began, m
  std::optional<double> way_start_, volume_start_, force_off_at_;
  bool valve_told_ = false, above_limit_ = false;
  std::vector<std::string> notes_;
};

}  // namespace triax::lab
