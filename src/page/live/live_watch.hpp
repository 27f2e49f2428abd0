// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A test that another program writes into the database, looked at again and again.
#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "src/page/live/live_feed.hpp"

namespace triax::src {

class LiveWatch {
 public:
  static constexpr std::chrono::milliseconds kLook{200};

  /// Throws as db::Store does.
  LiveWatch(const std::string& db, std::int64_t test);
  ~LiveWatch();
  LiveWatch(const LiveWatch&) = delete;
  LiveWatch& operator=(const LiveWatch&) = delete;

  const std::shared_ptr<LiveFeed>& feed() const { return feed_; }
  /// The test is over, or cannot be read any more.
  bool is_over() const { return over_; }

 private:
  struct Seen;
  void watch();
  bool look();

  std::int64_t test_;
  std::shared_ptr<LiveFeed> feed_ = std::make_shared<LiveFeed>();
  std::unique_ptr<Seen> seen_;
  std::atomic<bool> ending_ = false, over_ = false;
  std::thread thread_;
};

}  // namespace triax::src
