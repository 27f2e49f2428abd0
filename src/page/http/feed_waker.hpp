// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Wakes the streams of one test, all by one post: what is told while a test is recorded must cost
// its recorder the same for one browser and for ten.
#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "src/page/live/live_feed.hpp"

namespace triax::src {

/// All but the post happens in the thread of the executor.
class FeedWaker : public std::enable_shared_from_this<FeedWaker> {
 public:
  explicit FeedWaker(std::shared_ptr<LiveFeed> feed) : feed_(std::move(feed)) {}
  ~FeedWaker() {
    if (number_) feed_->forget(*number_);
  }
  FeedWaker(const FeedWaker&) = delete;
  FeedWaker& operator=(const FeedWaker&) = delete;

  void begin(const boost::asio::any_io_executor& executor) {
    number_ = feed_->listen([executor, weak = weak_from_this()] {
      boost::asio::post(executor, [weak] {
        if (const auto self = weak.lock()) self->wake();
      });
    });
  }
  void add(boost::asio::steady_timer& timer) { timers_.insert(&timer); }
  void remove(boost::asio::steady_timer& timer) { timers_.erase(&timer); }

 private:
  void wake() {
    for (auto* timer : timers_) timer->cancel();
  }

  std::shared_ptr<LiveFeed> feed_;
  std::optional<std::uint64_t> number_;
  std::set<boost::asio::steady_timer*> timers_;
};

/// The wakers of the feeds that somebody looks at.
class FeedWakers {
 public:
  std::shared_ptr<FeedWaker> of(const std::shared_ptr<LiveFeed>& feed,
                                const boost::asio::any_io_executor& executor) {
    std::erase_if(wakers_, [](const auto& entry) { return entry.second.expired(); });
    auto& kept = wakers_[feed.get()];
    if (auto waker = kept.lock()) return waker;
    auto waker = std::make_shared<FeedWaker>(feed);
    waker->begin(executor);
    kept = waker;
    return waker;
  }

 private:
  std::map<LiveFeed*, std::weak_ptr<FeedWaker>> wakers_;
};

/// A timer that is woken as long as this lives.
class WokenTimer {
 public:
  WokenTimer(std::shared_ptr<FeedWaker> waker, const boost::asio::any_io_executor& executor)
      : waker_(std::move(waker)), timer_(executor) {
    waker_->add(timer_);
  }
  ~WokenTimer() { waker_->remove(timer_); }
  WokenTimer(const WokenTimer&) = delete;
  WokenTimer& operator=(const WokenTimer&) = delete;
  boost::asio::steady_timer& operator*() { return timer_; }

 private:
  std::shared_ptr<FeedWaker> waker_;
  boost::asio::steady_timer timer_;
};

}  // namespace triax::src
