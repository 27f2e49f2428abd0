// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/task_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "src/output/words.hpp"

namespace triax::src {

TaskProgress::TaskProgress(int tasks) : tasks_(tasks), on_terminal_(isatty(STDERR_FILENO) == 1) {}

TaskProgress::~TaskProgress() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
}

void TaskProgress::next(std::string name) {
  ++task_;
  name_ = std::move(name);
  start_ = Clock::now();
}

void TaskProgress::show(double share, const std::string& what) {
  using namespace std::chrono_literals;
  const auto now = Clock::now();
  if (!on_terminal_ || (drawn_ && now - last_ < 200ms)) return;
  drawn_ = true;
  last_ = now;
  const std::chrono::duration<double> elapsed = now - start_;
  fmt::print(stderr, "\r\x1b[K{}",
             task_progress_text(task_, tasks_, name_, share, what, elapsed.count()));
  std::fflush(stderr);
}

std::string task_progress_text(int task, int tasks, const std::string& name, double share,
                               const std::string& what, double elapsed_s) {
  constexpr double kKnown = 0.01;
  const double done = std::clamp(share, 0.0, 1.0);
  std::string text = fmt::format("{}/{} {}: {}, {:.0f} %", task, tasks, name, what, 100 * done);
  if (done >= kKnown) text += fmt::format(", {} left", duration(elapsed_s * (1 - done) / done));
  return text;
}

}  // namespace triax::src
