// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/instruments/plain_line.hpp"

#include <utility>

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {
constexpr std::size_t kLongestPlainLine = 80;
constexpr double kPlainSilence_s = 0.25;
}  // namespace

void PlainLineConversation::take(std::string_view bytes, std::string& reply) {
  for (const char c : bytes) {
    if (c == '\n' || c == '\r') {
      end_of_line(reply);
      continue;
    }
    too_long_ = too_long_ || line_.size() == kLongestPlainLine;
    if (!too_long_) line_ += c;
  }
}

std::optional<double> PlainLineConversation::waits_s() const {
  return line_.empty() ? std::nullopt : std::optional(kPlainSilence_s);
}

void PlainLineConversation::end_of_line(std::string& reply) {
  const std::string line = std::exchange(line_, {});
  if (!std::exchange(too_long_, false) && !trimmed(line).empty()) answer(trimmed(line), reply);
}

}  // namespace triax::lab
