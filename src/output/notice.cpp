// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/notice.hpp"

#include <unistd.h>

#include <fmt/format.h>

#include <cstdio>
#include <mutex>

namespace triax::src {

void notify(const std::string& sentence) {
  static std::mutex mutex;
  static std::string last;
  const std::lock_guard lock(mutex);
  if (sentence == last) return;
  last = sentence;
  // A progress line may stand there.
  fmt::print(stderr, "{}triax: {}\n", isatty(STDERR_FILENO) == 1 ? "\r\x1b[K" : "", sentence);
  std::fflush(stderr);
}

}  // namespace triax::src
