// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/replay/answer_input.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace triax::src {

bool AnswerInput::is_terminal() const { return isatty(descriptor_) == 1; }

/// False at the end and after Ctrl-C.
bool AnswerInput::read_more() {
  constexpr int kWait_ms = 200;
  std::array<char, kMaxLine_bytes> bytes{};
  while (!interruption_.requested()) {
    pollfd input{descriptor_, POLLIN, 0};
    if (poll(&input, 1, kWait_ms) <= 0) continue;
    const ssize_t count = read(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    waiting_.append(bytes.data(), static_cast<std::size_t>(count));
    return true;
  }
  return false;
}

std::optional<std::string> AnswerInput::next() {
  std::string line;
  bool has_any = false;
  while (!interruption_.requested()) {
    const std::size_t end = waiting_.find('\n');
    has_any = has_any || !waiting_.empty();
    if (line.size() < kMaxLine_bytes)
      line += waiting_.substr(0, std::min(end, kMaxLine_bytes - line.size()));
    if (end != std::string::npos) {
      waiting_.erase(0, end + 1);
      return line;
    }
    waiting_.clear();
    if (!read_more()) break;
  }
  if (!has_any || interruption_.requested()) return std::nullopt;
  return line;
}

}  // namespace triax::src
