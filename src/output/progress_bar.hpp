// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <string>

namespace triax::src {

/// The progress line of a long run on standard error; draws nothing unless that is a terminal.
class ProgressBar {
 public:
  explicit ProgressBar(std::string label);
  ~ProgressBar();  ///< wipes the line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  void show(double fraction);

 private:
  std::string label_;
  bool on_terminal_;
  int shown_percent_ = -1;
};

/// For a study: a bar for what is under way, labelled with its name, that is wiped when something
/// else begins or the function goes.
std::function<void(const std::string& what, double fraction)> progress_bars();

}  // namespace triax::src
