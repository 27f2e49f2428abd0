// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <chrono>
#include <string>

namespace triax::src {

/// Progress of work made of tasks, on standard error, with the time that the one under way still
/// needs; draws nothing unless that is a terminal.
class TaskProgress {
 public:
  explicit TaskProgress(int tasks);
  ~TaskProgress();  ///< wipes the line
  TaskProgress(const TaskProgress&) = delete;
  TaskProgress& operator=(const TaskProgress&) = delete;

  /// The next task, from 1 on.
  void next(std::string name);
  /// `share` of the task is done; `what` is being done now. Draws at most five times a second.
  void show(double share, const std::string& what);

 private:
  using Clock = std::chrono::steady_clock;
  int tasks_;
  int task_ = 0;
  std::string name_;
  bool on_terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now(), last_;
};

/// "2/7 R 0.825: following the path, 40 %, 1.2 min left"; what is left is unknown before a
/// hundredth is done.
std::string task_progress_text(int task, int tasks, const std::string& name, double share,
                               const std::string& what, double elapsed_s);

}  // namespace triax::src
