// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/instruments/serial_pad.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace triax::lab {

SerialPad::SerialPad(const WireDevice& device, int bits)
    : device_(device), most_(std::ldexp(1.0, bits - 1)) {}

void SerialPad::answer(std::string_view line, std::string& reply) {
  if (device_.heard) device_.heard();
  if (line != "SS") {
    reply += "?\r\n";
    return;
  }
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    const bool there = channel < device_.points.size() && device_.points[channel].read;
    const double counts = there ? device_.points[channel].read() : NAN;
    reply +=
        std::isnan(counts)
            ? "OPEN\r\n"
            : fmt::format("{:.0f}\r\n", std::clamp(std::round(counts), -most_, most_ - 1) + 0.0);
  }
}

}  // namespace triax::lab
