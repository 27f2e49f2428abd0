// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <memory>

#include "src/page/live/live_feed.hpp"

namespace triax::src {

/// Wakes the stream when its feed has more; from the thread that records, which does not wait.
class FeedListener {
 public:
  FeedListener(LiveFeed& feed, const boost::asio::any_io_executor& executor,
               const std::shared_ptr<boost::asio::steady_timer>& timer)
      : feed_(feed), number_(feed.listen([executor, timer] {
          boost::asio::post(executor, [timer] { timer->cancel(); });
        })) {}
  ~FeedListener() { feed_.forget(number_); }
  FeedListener(const FeedListener&) = delete;
  FeedListener& operator=(const FeedListener&) = delete;

 private:
  LiveFeed& feed_;
  std::uint64_t number_;
};

}  // namespace triax::src
