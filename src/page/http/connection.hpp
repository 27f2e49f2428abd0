// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One browser's connection: one request after the other until it ends.
#include <array>
#include <atomic>
#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <chrono>
#include <memory>
#include <string>

#include "src/page/http/feed_waker.hpp"
#include "src/page/http/server.hpp"

namespace triax::src {

/// The threads of one queue, and how many requests are in it.
struct QueueThreads {
  explicit QueueThreads(std::size_t count) : threads(count) {}
  boost::asio::thread_pool threads;
  std::atomic<std::size_t> requests = 0;
};

/// What all connections share.
struct PageHouse {
  PageServerOptions options;
  std::unique_ptr<Gate> gate;
  /// In the order of WorkQueue. An upload in progress is one of `records`, which has a thread for
  /// each of them.
  std::array<QueueThreads, 5> queues;
  FeedWakers wakers;  ///< of the thread that waits on sockets

  explicit PageHouse(PageServerOptions o)
      : options(std::move(o)),
        queues{QueueThreads(1), QueueThreads(2), QueueThreads(3), QueueThreads(4),
               QueueThreads(options.limits.records)} {}
  QueueThreads& queue(WorkQueue which) { return queues.at(static_cast<std::size_t>(which)); }
};

/// There is one more of something as long as this lives.
class Counted {
 public:
  explicit Counted(std::atomic<std::size_t>& count) : count_(count) { ++count_; }
  ~Counted() { --count_; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;

 private:
  std::atomic<std::size_t>& count_;
};

class PageConnection {
 public:
  PageConnection(PageHouse& house, boost::asio::ip::tcp::socket socket)
      : house_(house), stream_(std::move(socket)) {}

  /// Until the browser or this server has enough.
  boost::asio::awaitable<void> run();
  /// Whether the gate has admitted a request of it.
  bool is_trusted() const { return trusted_; }
  /// Ends it, from the thread of its executor.
  void drop();

 private:
  using Head = boost::beast::http::request_parser<boost::beast::http::empty_body>;

  boost::asio::awaitable<bool> serve_one();
  boost::asio::awaitable<PageAnswer> answer(Head& head);
  boost::asio::awaitable<PageAnswer> admitted_answer(Head& head, const Target& target);
  PageAnswer let_in();
  boost::asio::awaitable<void> read_json(Head& head, PageRequest& request);
  boost::asio::awaitable<void> read_record(Head& head, PageRequest& request, QueueThreads& queue);
  boost::asio::awaitable<void> go_ahead(const Head& head);
  boost::asio::awaitable<PageAnswer> answer_to_record(Head& head, PageRequest request,
                                                      QueueThreads& queue);
  boost::asio::awaitable<PageAnswer> compute(PageRequest request, QueueThreads& queue,
                                             std::chrono::milliseconds time);
  static boost::asio::awaitable<PageAnswer> computed(const PageHouse& house,
                                                     std::shared_ptr<const PageRequest> request);
  boost::asio::awaitable<void> watch_client(std::shared_ptr<std::atomic<Cancelled>> cancelled,
                                            std::chrono::milliseconds time);
  boost::asio::awaitable<bool> send(PageAnswer answer, bool keep);
  boost::asio::awaitable<void> send_live(LiveStart live);
  boost::asio::awaitable<void> linger();
  bool is_gone();

  PageHouse& house_;
  boost::beast::tcp_stream stream_;
  boost::beast::flat_buffer buffer_;
  bool trusted_ = false;
  std::string cookie_;      ///< field of the last request that was admitted
  bool body_left_ = false;  ///< a body that nobody reads follows: nothing else can
  bool head_only_ = false;  ///< answers have no body
  bool is_first_ = true;
};

}  // namespace triax::src
