// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/api/desk.hpp"

#include <utility>

#include "src/page/request/request.hpp"

namespace triax::src {

std::string Desk::ask(std::function<std::string()> work) {
  constexpr std::size_t kMost = 8;
  std::future<std::string> done;
  {
    const std::lock_guard lock(mutex_);
    if (closed_) throw Refused(503, "triax open is shutting down");
    if (waiting_.size() >= kMost) throw Refused(503, "too many reports are being drawn; try again");
    std::packaged_task<std::string()> task(std::move(work));
    done = task.get_future();
    waiting_.push_back(std::move(task));
    come_.notify_one();
  }
  try {
    return done.get();
  } catch (const std::future_error&) {
    throw Refused(503, "triax open is shutting down");
  }
}

void Desk::work_for(std::chrono::milliseconds time) {
  const auto until = std::chrono::steady_clock::now() + time;
  std::unique_lock lock(mutex_);
  while (come_.wait_until(lock, until, [this] { return !waiting_.empty(); })) {
    auto task = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    task();
    lock.lock();
  }
}

void Desk::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  waiting_.clear();
}

}  // namespace triax::src
