// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

namespace triax::src {

ProgressBar::ProgressBar(std::string label)
    : label_(std::move(label)), on_terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (shown_percent_ >= 0) std::fputs("\r\x1b[K", stderr);
}

void ProgressBar::show(double fraction) {
  if (!on_terminal_) return;
  const int percent = static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0));
  if (percent == shown_percent_) return;
  shown_percent_ = percent;
  constexpr int kWidth = 40;
  const auto full = static_cast<std::size_t>(percent * kWidth / 100);
  fmt::print(stderr, "\r{} [{:<{}}] {:3} %", label_, std::string(full, '='), kWidth, percent);
  std::fflush(stderr);
}

std::function<void(const std::string&, double)> progress_bars() {
  struct Shown {
    std::string what;
    std::unique_ptr<ProgressBar> bar;
  };
  return [shown = std::make_shared<Shown>()](const std::string& what, double fraction) {
    if (!shown->bar || shown->what != what) {
      shown->bar.reset();
      shown->bar = std::make_unique<ProgressBar>(what);
      shown->what = what;
    }
    shown->bar->show(fraction);
  };
}

}  // namespace triax::src
