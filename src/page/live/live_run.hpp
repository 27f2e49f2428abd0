// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A test that this program runs for the page, on the virtual apparatus or on instruments.
#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "lab/programmes/programme.hpp"
#include "lab/rig/rig_software.hpp"
#include "lab/rig/session_listener.hpp"
#include "src/page/live/live_feed.hpp"

namespace triax::src {

struct RunAsked {
  lab::Programme programme;
  std::optional<std::uint64_t> seed;
  double speed = 0;  ///< as in lab::SessionOptions
  std::string rig;   ///< file of instruments; empty: the virtual apparatus
};

/// What somebody asks for while it runs.
struct RunOrder {
  enum class Kind { hold, resume, stop };
  Kind kind = Kind::hold;
  std::string who;  ///< one line
};

class LiveRun {
 public:
  /// Begins at once, in a thread of its own.
  LiveRun(std::string db, RunAsked asked);
  /// Ends the test in an orderly way: it is stored as far as it went.
  ~LiveRun();
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  /// Waits until the test has its number. Throws lab::BadInput or lab::WorkFailed where it came to
  /// nothing before that, or takes too long.
  std::int64_t test();
  const std::shared_ptr<LiveFeed>& feed() const { return feed_; }
  bool is_over() const { return over_; }
  bool is_held() const { return held_; }
  bool is_on_rig() const { return !asked_.rig.empty(); }
  /// From the next reading on; an event of the record says who and when. Throws Refused where the
  /// test is over, or is so already.
  void order(const RunOrder& order);
  /// Asks for its end; the destructor waits for it.
  void end() { ending_ = true; }

 private:
  void run();
  std::int64_t run_on(lab::RigSoftware& rig);
  bool look(lab::RigSoftware& rig);
  void obey(lab::RigSoftware& rig);
  void wait_while_held();
  lab::SessionListener listener();

  std::string db_;
  RunAsked asked_;
  std::shared_ptr<LiveFeed> feed_ = std::make_shared<LiveFeed>();
  lab::RecordHeader header_;
  std::atomic<bool> ending_ = false, over_ = false, held_ = false;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<RunOrder> orders_;
  std::optional<std::int64_t> id_;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace triax::src
