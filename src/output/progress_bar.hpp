#pragma once
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

}  // namespace triax::src
