// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The line on which a served rig's clock is read and turned. Only rigs of `triax serve` have one.
#include <string>

#include "lab/wire/device_modes.hpp"
#include "lab/wire/line/line.hpp"

namespace triax::lab {

/// How test time runs on a rig.
struct RigTime {
  double speed = 1;  ///< times the clock
  /// The client turns it: nothing happens between two steps.
  bool lock_step = false;
};

class ControlLine {
 public:
  static constexpr double kPatience_s = 30;  ///< grains take their time

  /// Waits until it stands. Throws WorkFailed, as every call below does where there is no answer.
  ControlLine(LineLoop& loop, const LinkAddress& link);

  RigTime ask_time();
  /// Lets dt pass in lock step; the frame's state after it.
  FrameState step(double dt_s);
  /// Any other question of the control tree (docs/how-to/instruments.md).
  std::string ask(const std::string& question);

 private:
  LineLoop& loop_;
  Line line_;
};

}  // namespace triax::lab
