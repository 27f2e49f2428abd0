// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/wire/instruments/plain_line.hpp"
#include "lab/wire/wire_device.hpp"

namespace triax::lab {

/// A serial pad: "SS" is answered by eight lines, the counts of its channels 1 to 8, each ended by
/// CR LF. Its channels are the first eight points of the device, in counts; the converter has
/// `bits` bits with a sign, and counts beyond stand at its end. A channel without a point, or
/// whose point has no value now, says OPEN. Anything else is answered by ?.
class SerialPad : public PlainLineConversation {
 public:
  static constexpr int kChannels = 8;
  /// The device outlives it. `bits`: 2 to 32.
  explicit SerialPad(const WireDevice& device, int bits = 24);

 protected:
  void answer(std::string_view line, std::string& reply) override;

 private:
  const WireDevice& device_;
  double most_;
};

}  // namespace triax::lab
