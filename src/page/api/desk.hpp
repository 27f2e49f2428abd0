// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Work for the first thread of the program: Qt draws in no other.
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <string>

namespace triax::src {

class Desk {
 public:
  /// Waits for what `work` gives, which the first thread does. Throws what it throws, or Refused
  /// where nobody works any longer or too much waits.
  std::string ask(std::function<std::string()> work);
  /// By the first thread: does what waits, for about so long.
  void work_for(std::chrono::milliseconds time);
  /// Nothing is done from now on; who waits is told.
  void close();

 private:
  std::mutex mutex_;
  std::condition_variable come_;
  std::deque<std::packaged_task<std::string()>> waiting_;
  bool closed_ = false;
};

}  // namespace triax::src
