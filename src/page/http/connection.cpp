// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/http/connection.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/experimental/awaitable_operators.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core/string.hpp>
#include <boost/beast/http/buffer_body.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <limits>
#include <optional>
#include <variant>

#include "lab/base/bad_input.hpp"
#include "src/page/http/guarded_headers.hpp"

namespace triax::src {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using asio::use_awaitable;
using Clock = std::chrono::steady_clock;

namespace {

constexpr std::string_view kTokenName = "token";

std::string_view field(const http::fields& fields, std::string_view name) {
  const auto found = fields.find(name);
  return found == fields.end() ? std::string_view() : std::string_view(found->value());
}

RequestHead head_of(const http::request<http::empty_body>& request, const Target& target) {
  RequestHead head;
  head.post = request.method() == http::verb::post;
  head.api = target.begins("api");
  head.host = field(request, "Host");
  head.cookie = field(request, "Cookie");
  head.site = field(request, "Sec-Fetch-Site");
  head.own_field = field(request, "X-Triax");
  if (request.count("Host") > 1) head.host = {};
  if (request.count("Origin") > 0) head.origin = field(request, "Origin");
  if (!head.post && target.path.empty())
    for (const auto& [name, value] : target.query)
      if (name == kTokenName) head.token = value;
  return head;
}

PageAnswer text_answer(unsigned status, const std::string& text) {
  return {.status = status, .type = "text/plain; charset=utf-8", .body = text + '\n'};
}

PageAnswer turned_away(Gate::Ruling ruling) {
  switch (ruling) {
    case Gate::Ruling::foreign_host:
      return text_answer(
          403, "This address does not belong to triax open. Open the address that it printed.");
    case Gate::Ruling::foreign_origin:
      return text_answer(403, "This request comes from a page of another site and is rejected.");
    case Gate::Ruling::no_field:
      return text_answer(403, "Changes need the header X-Triax: 1.");
    default:
      return text_answer(
          401,
          "This browser has no access, or its access has expired: after 12 hours without use, "
          "after 7 days, or at the end of triax open.\nOpen a new address; each works once, within "
          "an hour. A browser that has access makes one: \"Address for another browser\", at the "
          "foot of the page. triax open prints one when Enter is pressed in its terminal.");
  }
}

Refused json_too_long(const PageLimits& limits) {
  return {413, "the request is longer than " + std::to_string(limits.json_bytes) + " bytes"};
}

Refused record_too_long(const PageLimits& limits) {
  return {413, "the file is longer than the " + std::to_string(limits.record_bytes >> 20) +
                   " MB accepted here; use `triax replay`, which has no limit"};
}

/// Returns true if the parser of HTTP reports the error, not the connection.
bool is_http_error(const boost::system::error_code& error) {
  return error.category() == http::make_error_code(http::error::bad_target).category();
}

/// Of a body that cannot be read to its end.
[[noreturn]] void throw_for_body(const boost::system::error_code& error) {
  if (is_http_error(error) && error != http::error::partial_message)
    throw Refused(400, "the body of the request is not valid HTTP/1.1: " + error.message());
  throw boost::system::system_error(error);
}

/// Why a head that could be parsed is not served (RFC 9110 and 9112), or nothing.
std::optional<PageAnswer> fault_of(const http::request_parser<http::empty_body>& parser) {
  const http::request<http::empty_body>& head = parser.get();
  if (head.method() == http::verb::unknown)
    return error_answer(501, "unknown method; must be one of: GET, POST");
  if (head.version() == 11 && head.count(http::field::host) != 1)
    return error_answer(400, "a request of HTTP/1.1 must have one Host");
  const auto length = head[http::field::content_length];
  if (head.count(http::field::content_length) > 1 || length.find(',') != std::string_view::npos)
    return error_answer(400, "a request must have at most one Content-Length");
  if (head.count(http::field::transfer_encoding) > 0) {
    if (head.version() < 11 || head.count(http::field::content_length) > 0)
      return error_answer(400, "Transfer-Encoding is not allowed with Content-Length or HTTP/1.0");
    if (head.count(http::field::transfer_encoding) > 1 ||
        !boost::beast::iequals(head[http::field::transfer_encoding], "chunked"))
      return error_answer(501, "unknown Transfer-Encoding; only chunked is supported");
  }
  if (const auto expected = head[http::field::expect];
      !expected.empty() && !boost::beast::iequals(expected, "100-continue"))
    return error_answer(417, "unknown Expect; only 100-continue is supported");
  return std::nullopt;
}

/// By a thread of a queue. Pre-condition: the upload and the bytes outlive it.
asio::awaitable<void> write_part(Upload& upload, std::string_view part) {
  upload.write(part);
  co_return;
}

/// Whether more follows than the head.
bool has_body(const http::request_parser<http::empty_body>& head) {
  return head.chunked() || head.content_length().value_or(0) > 0;
}

}  // namespace

void PageConnection::drop() {
  boost::system::error_code ignored;
  stream_.socket().close(ignored);
}

asio::awaitable<void> PageConnection::run() {
  try {
    while (co_await serve_one()) {
    }
  } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch)
    // It is gone, or took too long; one connection is not worth the others.
  }
  drop();
}

/// One request; false where no other follows.
asio::awaitable<bool> PageConnection::serve_one() {
  const PageLimits& limits = house_.options.limits;
  Head head;
  head.header_limit(limits.header_bytes);
  head.body_limit(std::numeric_limits<std::uint64_t>::max());
  stream_.expires_after(is_first_ ? limits.header_time : limits.idle);
  is_first_ = false;
  boost::system::error_code error;
  co_await http::async_read_header(stream_, buffer_, head,
                                   asio::redirect_error(use_awaitable, error));
  if (error == http::error::header_limit || error == http::error::buffer_overflow) {
    body_left_ = true;
    co_return co_await send(error_answer(431, "the head of the request is too long"), false);
  }
  if (error && (error == http::error::end_of_stream || !is_http_error(error))) co_return false;
  if (error == http::error::bad_version)
    co_return co_await send(error_answer(505, "only HTTP/1.0 and HTTP/1.1 are supported"), false);
  if (error) co_return co_await send(error_answer(400, "this is not a request of HTTP/1.1"), false);
  body_left_ = has_body(head);
  if (auto fault = fault_of(head)) {
    body_left_ = true;  // its end is unknown
    co_return co_await send(std::move(*fault), false);
  }
  const bool keep = head.get().keep_alive();
  head_only_ = head.get().method() == http::verb::head;
  PageAnswer answered = co_await answer(head);
  if (answered.live) {
    co_await send_live(std::move(*answered.live));
    co_return false;
  }
  co_return co_await send(std::move(answered), keep && !body_left_);
}

PageAnswer PageConnection::let_in() {
  trusted_ = true;
  return {.status = 303,
          .type = "text/plain; charset=utf-8",
          .body = "",
          .fields = {{"Location", "/"},
                     {"Set-Cookie", house_.gate->new_cookie() +
                                        "; HttpOnly; SameSite=Strict; Path=/; Max-Age=" +
                                        std::to_string(house_.options.access.absolute.count())}}};
}

/// Nothing of a body is read before it is known that its sender may, and no token is used up by
/// what is not answered.
asio::awaitable<PageAnswer> PageConnection::answer(Head& head) {
  const auto target = parse_target(head.get().target());
  if (!target) co_return error_answer(400, "the address of the request is not valid");
  const auto method = head.get().method();
  if (method != http::verb::get && method != http::verb::post) {
    PageAnswer other = error_answer(405, "only GET and POST are supported");
    other.fields = {{"Allow", "GET, POST"}};
    co_return other;
  }
  PageAnswer refused;
  try {
    const Gate::Ruling ruling = house_.gate->judge(head_of(head.get(), *target));
    if (ruling == Gate::Ruling::enters) co_return let_in();
    if (ruling != Gate::Ruling::admitted) co_return turned_away(ruling);
    trusted_ = true;
    cookie_ = field(head.get(), "Cookie");
    co_return co_await admitted_answer(head, *target);
  } catch (const Refused& error) {
    refused = error_answer(error.status(), error.what());
  } catch (const lab::WorkFailed& error) {
    refused = error_answer(507, error.what());
  }
  co_return refused;
}

asio::awaitable<PageAnswer> PageConnection::admitted_answer(Head& head, const Target& target) {
  PageRequest request{.post = head.get().method() == http::verb::post, .target = target};
  if (const auto last = field(head.get(), "Last-Event-ID"); !last.empty())
    request.last_event = std::string(last);
  if (!request.post && has_body(head))
    co_return error_answer(400, "a GET request must not have a body");
  const auto& queue_of = house_.options.queue_of;
  const WorkQueue which = queue_of ? queue_of(request) : WorkQueue::light;
  QueueThreads& queue = house_.queue(which);
  if (which == WorkQueue::records)
    co_return co_await answer_to_record(head, std::move(request), queue);
  if (request.post) co_await read_json(head, request);
  if (which != WorkQueue::orders && queue.requests >= house_.options.limits.waiting_answers)
    throw Refused(503, "too many requests at once; try again later");
  const Counted counted(queue.requests);
  co_return co_await compute(std::move(request), queue, house_.options.limits.answer_time);
}

/// Uploads lie on the disk already while they arrive: there are few at a time.
asio::awaitable<PageAnswer> PageConnection::answer_to_record(Head& head, PageRequest request,
                                                             QueueThreads& queue) {
  const PageLimits& limits = house_.options.limits;
  if (queue.requests >= limits.records)
    throw Refused(503, "too many records are sent at once; try again later");
  const Counted counted(queue.requests);
  co_await read_record(head, request, queue);
  const auto time = limits.time_to_read(request.upload->size());
  co_return co_await compute(std::move(request), queue, time);
}

/// A client that asks first whether its body is wanted.
asio::awaitable<void> PageConnection::go_ahead(const Head& head) {
  if (field(head.get(), "Expect").empty()) co_return;
  constexpr std::string_view kContinue = "HTTP/1.1 100 Continue\r\n\r\n";
  co_await asio::async_write(stream_, asio::buffer(kContinue), use_awaitable);
}

asio::awaitable<void> PageConnection::read_json(Head& head, PageRequest& request) {
  const PageLimits& limits = house_.options.limits;
  if (head.content_length().value_or(0) > limits.json_bytes) throw json_too_long(limits);
  stream_.expires_after(limits.json_time);
  co_await go_ahead(head);
  http::request_parser<http::string_body> whole(std::move(head));
  whole.body_limit(limits.json_bytes);
  boost::system::error_code error;
  co_await http::async_read(stream_, buffer_, whole, asio::redirect_error(use_awaitable, error));
  if (error == http::error::body_limit) throw json_too_long(limits);
  if (error) throw_for_body(error);
  body_left_ = false;
  request.body = std::move(whole.get().body());
}

/// A slow disk holds up a thread of the queue, not the one that waits on all sockets.
asio::awaitable<void> PageConnection::read_record(Head& head, PageRequest& request,
                                                  QueueThreads& queue) {
  const PageLimits& limits = house_.options.limits;
  if (head.content_length().value_or(0) > limits.record_bytes) throw record_too_long(limits);
  stream_.expires_after(limits.record_quiet);
  co_await go_ahead(head);
  request.upload = std::make_shared<Upload>(house_.options.upload_folder);
  http::request_parser<http::buffer_body> parts(std::move(head));
  parts.body_limit(std::numeric_limits<std::uint64_t>::max());
  std::vector<char> part(std::size_t{256} << 10);
  const auto until = Clock::now() + limits.record_time;
  while (!parts.is_done()) {
    if (Clock::now() > until) throw Refused(408, "the upload took too long");
    stream_.expires_after(limits.record_quiet);
    parts.get().body().data = part.data();
    parts.get().body().size = part.size();
    boost::system::error_code error;
    co_await http::async_read(stream_, buffer_, parts, asio::redirect_error(use_awaitable, error));
    if (error && error != http::error::need_buffer) throw_for_body(error);
    const std::size_t come = part.size() - parts.get().body().size;
    if (request.upload->size() + come > limits.record_bytes) throw record_too_long(limits);
    co_await asio::co_spawn(queue.threads, write_part(*request.upload, {part.data(), come}),
                            use_awaitable);
  }
  body_left_ = false;
}

/// By a thread of a queue.
asio::awaitable<PageAnswer> PageConnection::computed(const PageHouse& house,
                                                     std::shared_ptr<const PageRequest> request) {
  try {
    throw_if_cancelled(*request);
    co_return house.options.answer(*request);
  } catch (const Refused& error) {
    co_return error_answer(error.status(), error.what());
  } catch (const lab::BadInput& error) {
    co_return error_answer(400, error.what());
  } catch (const std::bad_alloc&) {
    co_return error_answer(503, "not enough memory for this request");
  } catch (const std::exception& error) {
    co_return error_answer(500, error.what());
  }
}

/// Cancels the request once its client is gone or `time` is over. Ends only when it is cancelled
/// itself, as the answer is there.
asio::awaitable<void> PageConnection::watch_client(
    std::shared_ptr<std::atomic<Cancelled>> cancelled, std::chrono::milliseconds time) {
  constexpr std::chrono::milliseconds kLook{200};
  const auto until = Clock::now() + time;
  asio::steady_timer look(stream_.get_executor());
  for (;;) {
    look.expires_after(kLook);
    co_await look.async_wait(use_awaitable);
    if (is_gone())
      *cancelled = Cancelled::client_gone;
    else if (Clock::now() > until)
      *cancelled = Cancelled::too_late;
  }
}

asio::awaitable<PageAnswer> PageConnection::compute(PageRequest request, QueueThreads& queue,
                                                    std::chrono::milliseconds time) {
  using asio::experimental::awaitable_operators::operator||;
  const auto cancelled = std::make_shared<std::atomic<Cancelled>>(Cancelled::no);
  request.cancelled = cancelled;
  const auto shared = std::make_shared<const PageRequest>(std::move(request));
  stream_.expires_never();
  auto first = co_await (asio::co_spawn(queue.threads, computed(house_, shared), use_awaitable) ||
                         watch_client(cancelled, time));
  PageAnswer answer = std::get<0>(std::move(first));
  if (*cancelled == Cancelled::client_gone) throw boost::system::system_error(asio::error::eof);
  if (*cancelled == Cancelled::too_late && answer.status != 200)
    co_return error_answer(
        503, "the request was stopped after " +
                 std::to_string(std::chrono::ceil<std::chrono::seconds>(time).count()) +
                 " s, the time limit of the web interface; the commands of triax have no limit");
  co_return answer;
}

asio::awaitable<bool> PageConnection::send(PageAnswer answer, bool keep) {
  http::response<http::string_body> response(static_cast<http::status>(answer.status), 11);
  guard_headers(response, answer);
  response.keep_alive(keep);
  response.body() = std::move(answer.body);
  response.prepare_payload();
  if (head_only_) response.body().clear();
  constexpr std::size_t kSlowest = 100'000;  // bytes a second
  stream_.expires_after(house_.options.limits.write_time +
                        std::chrono::seconds(response.body().size() / kSlowest));
  co_await http::async_write(stream_, response, use_awaitable);
  if (!keep) co_await linger();
  co_return keep;
}

/// What a client still sends is taken for a while: closed at once, the answer would be lost to it.
asio::awaitable<void> PageConnection::linger() {
  boost::system::error_code error;
  stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, error);
  if (!body_left_) co_return;
  constexpr std::size_t kMost = std::size_t{32} << 20;
  stream_.expires_after(std::chrono::seconds(2));
  std::vector<char> part(std::size_t{64} << 10);
  for (std::size_t taken = 0; taken < kMost && !error;)
    taken += co_await stream_.async_read_some(asio::buffer(part),
                                              asio::redirect_error(use_awaitable, error));
}

}  // namespace triax::src
