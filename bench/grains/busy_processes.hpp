// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Processes that compute without end: the other work of a shared machine.
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <vector>

namespace triax::bench {

/// They run as long as this lives, and end with the program that made them. Pre-condition: the
/// program has one thread when they are made. Throws std::runtime_error if one cannot be started.
class BusyProcesses {
 public:
  explicit BusyProcesses(int count) {
    for (int k = 0; k < count; ++k) {
      const pid_t made = fork();
      if (made < 0) throw std::runtime_error("a busy process could not be started");
      if (made == 0) compute();
      running_.push_back(made);
    }
  }
  ~BusyProcesses() {
    for (const pid_t one : running_) {
      kill(one, SIGKILL);
      waitpid(one, nullptr, 0);
    }
  }
  BusyProcesses(const BusyProcesses&) = delete;
  BusyProcesses& operator=(const BusyProcesses&) = delete;

 private:
  [[noreturn]] static void compute() {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    volatile double sum = 0;
    for (;;) sum = sum + 1;
  }
  std::vector<pid_t> running_;
};

}  // namespace triax::bench
