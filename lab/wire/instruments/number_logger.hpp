// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/wire/instruments/plain_line.hpp"
#include "lab/wire/wire_device.hpp"

namespace triax::lab {

/// The plainest logger: a number a line, ended by CR LF. Asked, it answers any line with the value
/// of the device's first point; where `every_s` is above 0 it says it unasked, so often, and hears
/// nothing. No value now is an empty line.
class NumberLogger : public PlainLineConversation {
 public:
  /// The device outlives it.
  explicit NumberLogger(const WireDevice& device, double every_s = 0)
      : device_(device), every_s_(every_s) {}

  std::optional<double> waits_s() const override;
  void silent(std::string& reply) override;

 protected:
  void answer(std::string_view line, std::string& reply) override;

 private:
  void say(std::string& reply) const;
  const WireDevice& device_;
  double every_s_;
};

}  // namespace triax::lab
