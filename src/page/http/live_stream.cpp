// SPDX-License-Identifier: GPL-3.0-or-later
// The stream of a test that runs, to one browser.
#include <poll.h>

#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/serializer.hpp>
#include <boost/beast/http/write.hpp>

#include "src/page/http/connection.hpp"
#include "src/page/http/feed_waker.hpp"
#include "src/page/http/guarded_headers.hpp"
#include "src/page/live/live_frames.hpp"

namespace triax::src {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using asio::use_awaitable;
using Clock = std::chrono::steady_clock;

namespace {

constexpr std::size_t kMostAtOnce = 512;
/// Between two parts: a test that runs a thousand times the clock does not send thousands of them.
constexpr std::chrono::milliseconds kApart{10};
/// How often it is looked whether the browser is still there.
constexpr std::chrono::milliseconds kLook{1000};

}  // namespace

bool PageConnection::is_gone() {
  pollfd client{stream_.socket().native_handle(), POLLRDHUP, 0};
  return client.fd < 0 || ::poll(&client, 1, 0) > 0;
}

asio::awaitable<void> PageConnection::send_live(LiveStart live) {
  const PageLimits& limits = house_.options.limits;
  http::response<http::empty_body> head(http::status::ok, 11);
  guard_headers(head, {.type = "text/event-stream"});
  head.keep_alive(false);
  http::response_serializer<http::empty_body> whole(head);
  stream_.expires_after(limits.write_time);
  co_await http::async_write_header(stream_, whole, use_awaitable);
  const asio::any_io_executor executor = stream_.get_executor();
  WokenTimer timer(house_.wakers.of(live.feed, executor), executor);
  asio::steady_timer apart(executor);
  LiveFeed::Cursor cursor;
  if (live.after) cursor.after = live_position(*live.after);
  auto written = Clock::now(), seen = written;
  std::string frames = "retry: 500\n\n";
  for (bool over = false; !over;) {
    const LiveTaken taken = live.feed->take(cursor, kMostAtOnce);
    frames += live_frames(taken);
    over = taken.over;
    if (frames.empty() && Clock::now() - written > limits.heartbeat) frames = ": heartbeat\n\n";
    if (Clock::now() - seen > limits.heartbeat) {  // an open stream is use of its browser's access
      if (!house_.gate->has_access(cookie_)) break;
      seen = Clock::now();
    }
    const bool idle = frames.empty();
    if (!idle) {
      stream_.expires_after(limits.write_time);
      co_await asio::async_write(stream_, asio::buffer(frames), use_awaitable);
      written = Clock::now();
      frames.clear();
    }
    if (over) break;
    boost::system::error_code woken;
    if (idle) {
      (*timer).expires_after(kLook);
      co_await (*timer).async_wait(asio::redirect_error(use_awaitable, woken));
    } else if (taken.items.size() < kMostAtOnce) {
      apart.expires_after(kApart);
      co_await apart.async_wait(asio::redirect_error(use_awaitable, woken));
    }
    if (idle && is_gone()) co_return;
  }
  co_await linger();
}

}  // namespace triax::src
