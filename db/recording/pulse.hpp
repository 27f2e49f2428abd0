// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "db/recording/lease.hpp"

namespace triax::db {

/// Gives the signs of life of a lease on a thread and a connection of its own, while its writer
/// computes for hours without a word to the database. A sign that cannot be given (a lock, a full
/// disk) is left out.
class Pulse {
 public:
  /// The lease has been taken.
  Pulse(std::string path, Lease lease);
  ~Pulse();
  Pulse(const Pulse&) = delete;
  Pulse& operator=(const Pulse&) = delete;

 private:
  void beat();

  const std::string path_;
  Lease lease_;
  std::mutex mutex_;
  std::condition_variable end_;
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace triax::db
