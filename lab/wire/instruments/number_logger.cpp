// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/instruments/number_logger.hpp"

#include <fmt/format.h>

#include <cmath>

namespace triax::lab {

std::optional<double> NumberLogger::waits_s() const {
  return every_s_ > 0 ? std::optional(every_s_) : PlainLineConversation::waits_s();
}

void NumberLogger::silent(std::string& reply) {
  if (every_s_ > 0)
    say(reply);
  else
    PlainLineConversation::silent(reply);
}

void NumberLogger::answer(std::string_view, std::string& reply) {
  if (device_.heard) device_.heard();
  if (!(every_s_ > 0)) say(reply);
}

void NumberLogger::say(std::string& reply) const {
  const double value = device_.points.front().read();
  reply += std::isnan(value) ? "\r\n" : fmt::format("{:.10g}\r\n", value);
}

}  // namespace triax::lab
