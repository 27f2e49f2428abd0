// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A few threads that run one function together, again and again, and meet in between.
#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace triax::sim {

/// Where all threads of a team wait for each other: spinning, as they come within microseconds, and
/// asleep when they do not, so that a machine with other work is not held up.
class MeetingPoint {
 public:
  explicit MeetingPoint(int threads) : threads_(threads) {}
  void wait();

 private:
  const int threads_;
  alignas(64) std::atomic<int> arrived_{0};
  alignas(64) std::atomic<unsigned> round_{0};
};

class Team {
 public:
  /// The calling thread is number 0; starts `threads` − 1 others, which sleep between runs.
  explicit Team(int threads);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  int size() const { return static_cast<int>(others_.size()) + 1; }
  /// task(0) here, task(1) and on in the other threads; returns when all have. Tasks must not
  /// throw.
  void run(const std::function<void(int)>& task);

 private:
  void serve(int thread);

  std::mutex mutex_;
  std::condition_variable wake_, done_;
  const std::function<void(int)>* task_ = nullptr;
  unsigned round_ = 0;
  int running_ = 0;
  bool leaving_ = false;
  std::vector<std::thread> others_;
};

}  // namespace triax::sim
