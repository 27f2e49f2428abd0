// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Registers and the error queue that every client of an instrument has for itself (IEEE 488.2
// chapter 11, SCPI-99 volume 1 chapter 9). On a line of bytes replies keep their order and no read
// can be seen, so that -410 and -420 never come about.
#include <cstdint>
#include <deque>
#include <string>

#include "lab/wire/scpi/scpi_error.hpp"

namespace triax::lab {

class ScpiStatus {
 public:
  // Bits of the standard event register.
  static constexpr unsigned kOperationComplete = 1, kQueryError = 4, kDeviceError = 8,
                            kExecutionError = 16, kCommandError = 32, kPowerOn = 128;
  // Bits of the status byte.
  static constexpr unsigned kErrors = 4, kQuestionable = 8, kMessage = 16, kEvents = 32,
                            kMaster = 64, kOperation = 128;
  static constexpr std::size_t kMostErrors = 20;

  /// A group of three registers: what is, what was since it was read, what counts.
  struct Group {
    unsigned condition = 0, event = 0, enable = 0;
    /// Bits that come on are events.
    void is(unsigned now) {
      event |= now & ~condition;
      condition = now;
    }
    /// Reading clears it.
    unsigned take_event();
  };

  /// At the end of the queue; where it is full the last becomes -350. Sets the bit of its class.
  void put(const ScpiError& error);
  /// The first as SYSTem:ERRor? answers, and takes it away: -222,"Data out of range"; 0,"No error".
  std::string take_error();
  std::size_t errors() const { return errors_.size(); }
  /// *CLS: events and queue, not what is enabled. *RST does nothing here.
  void clear();

  void set_event(unsigned bits) { standard.event |= bits; }
  /// *STB?; `message`: an answer stands in the output.
  unsigned status_byte(bool message) const;

  Group standard{.event = kPowerOn};  ///< has no condition
  Group questionable, operation;
  unsigned request_enable = 0;  ///< *SRE, without bit 6

 private:
  struct Error {
    int code;
    std::string text;
  };
  std::deque<Error> errors_;
};

}  // namespace triax::lab
