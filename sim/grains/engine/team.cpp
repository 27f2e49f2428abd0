// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/team.hpp"

#if defined(__x86_64__)
#include <emmintrin.h>
#endif

namespace triax::sim {
namespace {

constexpr int kSpins = 4000;

void breathe() {
#if defined(__x86_64__)
  _mm_pause();
#endif
}

}  // namespace

void MeetingPoint::wait() {
  if (threads_ == 1) return;
  const unsigned round = round_.load(std::memory_order_relaxed);
  if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == threads_) {
    arrived_.store(0, std::memory_order_relaxed);
    round_.store(round + 1, std::memory_order_release);
    round_.notify_all();
    return;
  }
  for (int spin = 0; spin < kSpins; ++spin) {
    if (round_.load(std::memory_order_acquire) != round) return;
    breathe();
  }
  round_.wait(round, std::memory_order_acquire);
}

Team::Team(int threads) {
  for (int t = 1; t < threads; ++t) others_.emplace_back([this, t] { serve(t); });
}

Team::~Team() {
  {
    const std::lock_guard lock(mutex_);
    leaving_ = true;
  }
  wake_.notify_all();
  for (std::thread& t : others_) t.join();
}

void Team::run(const std::function<void(int)>& task) {
  if (others_.empty()) {
    task(0);
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    task_ = &task;
    running_ = static_cast<int>(others_.size());
    ++round_;
  }
  wake_.notify_all();
  task(0);
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return running_ == 0; });
}

void Team::serve(int thread) {
  unsigned seen = 0;
  for (;;) {
    std::unique_lock lock(mutex_);
    wake_.wait(lock, [&] { return leaving_ || round_ != seen; });
    if (leaving_) return;
    seen = round_;
    const auto* task = task_;
    lock.unlock();
    (*task)(thread);
    lock.lock();
    if (--running_ == 0) done_.notify_one();
  }
}

}  // namespace triax::sim
