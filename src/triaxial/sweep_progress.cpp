// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sweep_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "src/output/words.hpp"

namespace triax::src {

std::string progress_text(const study::SweepCounts& counts, std::int64_t total, double elapsed_s) {
  std::string text = fmt::format("{} of {} tests", counts.done, total);
  if (counts.failed > 0) text += fmt::format(", {} failed", counts.failed);
  if (counts.done > 0) {
    const auto left = static_cast<double>(total - counts.done) / static_cast<double>(counts.done);
    text += fmt::format(", {} left", duration(elapsed_s * left));
  }
  return text;
}

SweepProgress::SweepProgress(std::int64_t total)
    : total_(total), on_terminal_(isatty(STDERR_FILENO) == 1) {}

SweepProgress::~SweepProgress() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
}

void SweepProgress::show(const study::SweepCounts& counts) {
  if (!on_terminal_) return;
  drawn_ = true;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  fmt::print(stderr, "\r\x1b[K{}", progress_text(counts, total_, elapsed.count()));
  std::fflush(stderr);
}

}  // namespace triax::src
