// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/domain_run.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace triax::sim {
namespace {

/// Columns are taken from one counter; results have places of their own.
class DomainRun {
 public:
  DomainRun(const DomainGrid& grid, const std::vector<int>& columns)
      : grid_(grid), columns_(columns), results_(columns.size()) {}

  void work(const DomainWorker& worker) {
    try {
      for (std::size_t i = next_++; i < columns_.size() && !stopped_; i = next_++) {
        results_[i] = domain_column(worker.material, grid_, columns_[i], worker.criteria);
        ++done_;
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      stopped_ = true;
    }
    const std::lock_guard lock(mutex_);
    ++ended_;
    end_.notify_one();
  }

  /// Waits for all threads, telling now and then how far they are.
  void wait(std::size_t threads, const std::function<bool(double)>& progress) {
    using namespace std::chrono_literals;
    std::unique_lock lock(mutex_);
    while (!end_.wait_for(lock, 50ms, [&] { return ended_ == threads; })) {
      if (!progress || stopped_) continue;
      lock.unlock();
      const bool on = progress(static_cast<double>(done_) / static_cast<double>(columns_.size()));
      lock.lock();
      if (!on) stopped_ = true;
    }
  }

  void stop() { stopped_ = true; }

  std::vector<DomainColumn> result() {
    if (failure_) std::rethrow_exception(failure_);
    if (done_ < columns_.size()) return {};
    return std::move(results_);
  }

 private:
  const DomainGrid& grid_;
  const std::vector<int>& columns_;
  std::vector<DomainColumn> results_;
  std::atomic<std::size_t> next_ = 0, done_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex mutex_;
  std::condition_variable end_;
  std::size_t ended_ = 0;
  std::exception_ptr failure_;
};

std::size_t threads_for(std::size_t columns, int wanted) {
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  return std::min(columns, wanted > 0 ? static_cast<std::size_t>(wanted) : cores);
}

}  // namespace

std::vector<DomainColumn> run_domain(const DomainGrid& grid, const std::vector<int>& columns,
                                     const DomainWorkerFactory& factory,
                                     const DomainRunOptions& options) {
  std::vector<DomainWorker> workers;
  for (std::size_t i = threads_for(columns.size(), options.threads); i > 0; --i)
    workers.push_back(factory());
  DomainRun run(grid, columns);
  {
    std::vector<std::jthread> threads;
    try {
      for (const DomainWorker& worker : workers)
        threads.emplace_back([&run, &worker] { run.work(worker); });
      run.wait(workers.size(), options.progress);
    } catch (...) {
      run.stop();
      throw;
    }
  }
  return run.result();
}

std::vector<int> columns_of_piece(const DomainGrid& grid, int index, int count) {
  if (count < 1 || index < 1 || index > count)
    throw std::invalid_argument("no piece " + std::to_string(index) + " of " +
                                std::to_string(count));
  std::vector<int> columns;
  for (int column = index - 1; column < grid.columns; column += count) columns.push_back(column);
  return columns;
}

}  // namespace triax::sim
