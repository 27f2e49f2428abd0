// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One instrument of a virtual rig on its line: which code speaks for it follows from its
// personality. Drives speak by the commands and registers of their personality file; meters,
// scanners, pads and loggers have code of their own (lab/wire/instruments).
#include <functional>
#include <memory>
#include <string>

#include "lab/wire/conversation.hpp"
#include "lab/wire/rig_file.hpp"
#include "lab/wire/served/served_devices.hpp"
#include "lab/wire/served/spoilt_conversation.hpp"

namespace triax::lab {

enum class Pretence { itself, other_make, twin };

class ServedInstrument {
 public:
  /// `described` and `drives` outlive it. Throws BadInput for a personality that none of ours has.
  ServedInstrument(const RigInstrument& described, const ServedPlant& plant, ServedDrives& drives);
  ServedInstrument(const ServedInstrument&) = delete;
  ServedInstrument& operator=(const ServedInstrument&) = delete;

  const RigInstrument& described() const { return described_; }
  /// A talk for one more client.
  std::unique_ptr<Conversation> conversation();
  /// Moves a clock of its own on, where it has one.
  void process(double time_s);

  /// It says from now on that it is of another make, another one of its make, or itself again.
  void pretend(Pretence as);
  void set_frame_fault(FrameFault fault) { fault_ = fault; }
  /// Its own clock runs `rate` times as fast from now on, and jumps by `jump_s` first.
  void set_clock(double rate, double jump_s);

 private:
  void make_conversation(bool modbus);
  void read_channels(const ServedPlant& plant);

  const RigInstrument& described_;
  ServedDrives& drives_;
  WireDevice device_;
  std::string identity_;
  FrameFault fault_ = FrameFault::none;
  std::shared_ptr<void> speaker_;  ///< what the conversations are made from
  std::function<std::unique_ptr<Conversation>()> talk_;
  std::function<void(double)> process_, shift_calendar_;
  double time_s_ = 0, own_s_ = 0, rate_ = 1;  ///< of the test, of its own clock
};

}  // namespace triax::lab
