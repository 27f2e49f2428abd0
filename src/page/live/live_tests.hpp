// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// All tests that run or are watched.
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "src/page/live/live_run.hpp"
#include "src/page/live/live_watch.hpp"

namespace triax::src {

class LiveTests {
 public:
  explicit LiveTests(std::string db) : db_(std::move(db)) {}

  /// Runs a test; gives its number. Throws as LiveRun::test(), and Refused where too many run or
  /// the rig is at work.
  std::int64_t run(RunAsked asked);
  /// Throws Refused where this program does not run it.
  void order(std::int64_t test, const RunOrder& order);

  struct Control {
    bool controlled = false;  ///< this program runs it
    bool held = false;
  };
  Control control_of(std::int64_t test);
  /// What happens in a test, whoever runs it; a feed that has ended where nothing does.
  std::shared_ptr<LiveFeed> feed_of(std::int64_t test);
  /// All that run come to an end and are stored; nothing begins any more.
  void end();

 private:
  std::shared_ptr<LiveFeed> known_feed(std::int64_t test) const;
  std::shared_ptr<LiveFeed> watched_feed(std::int64_t test);
  void check_room_to_watch() const;

  std::string db_;
  std::mutex mutex_;
  std::list<std::shared_ptr<LiveRun>> beginning_;
  std::map<std::int64_t, std::shared_ptr<LiveRun>> runs_;
  std::map<std::int64_t, std::shared_ptr<LiveWatch>> watches_;
  bool ended_ = false;
};

}  // namespace triax::src
