// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/http/connection.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/http/buffer_body.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <limits>

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
      return text_answer(403,
                         "This address is none of triax open's: open the one that it printed.");
    case Gate::Ruling::foreign_origin:
      return text_answer(403, "A page of another site asked for this; it is not answered.");
    case Gate::Ruling::no_field:
      return text_answer(403, "Changes need the header X-Triax: 1.");
    default:
      return text_answer(
          401,
          "This browser has not been let in, or triax open was started anew.\n"
          "Open the address that triax open printed when it was started; it works "
          "once. A browser that is in already gives a new one: \"Address for another "
          "browser\", at the foot of the page.");
  }
}

Refused json_too_long(const PageLimits& limits) {
  return {413, "the request is longer than " + std::to_string(limits.json_bytes) + " bytes"};
}

Refused record_too_long(const PageLimits& limits) {
  return {413, "the file is longer than the " + std::to_string(limits.record_bytes >> 20) +
                   " MB that are taken in here; `triax replay` reads files of any length"};
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
  const auto& ours = http::make_error_code(http::error::bad_target).category();
  if (error && (error == http::error::end_of_stream || error.category() != ours)) co_return false;
  if (error) co_return co_await send(error_answer(400, "this is no request of HTTP/1.1"), false);
  body_left_ = has_body(head);
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
          .fields = {
              {"Location", "/"},
              {"Set-Cookie", house_.gate->new_cookie() + "; HttpOnly; SameSite=Strict; Path=/"}}};
}

/// Nothing of a body is read before it is known that its sender may, and no token is used up by
/// what is not answered.
asio::awaitable<PageAnswer> PageConnection::answer(Head& head) {
  const auto target = parse_target(head.get().target());
  if (!target) co_return error_answer(400, "the address of the request is not valid");
  const auto method = head.get().method();
  if (method != http::verb::get && method != http::verb::post) {
    PageAnswer other = error_answer(405, "only GET and POST are answered");
    other.fields = {{"Allow", "GET, POST"}};
    co_return other;
  }
  PageAnswer refused;
  try {
    const Gate::Ruling ruling = house_.gate->judge(head_of(head.get(), *target));
    if (ruling == Gate::Ruling::enters) co_return let_in();
    if (ruling != Gate::Ruling::admitted) co_return turned_away(ruling);
    trusted_ = true;
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
  if (!request.post && has_body(head)) co_return error_answer(400, "a GET has no body");
  if (request.post && target.begins("api", "records"))
    co_return co_await answer_to_record(head, std::move(request));
  if (request.post) co_await read_json(head, request);
  co_return co_await work_out(std::move(request));
}

/// Records that come lie on the disk already: there are few at a time.
asio::awaitable<PageAnswer> PageConnection::answer_to_record(Head& head, PageRequest request) {
  if (house_.records >= house_.options.limits.records)
    throw Refused(503, "too many records are sent at once; send it again in a while");
  const Counted counted(house_.records);
  co_await read_record(head, request);
  co_return co_await work_out(std::move(request));
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
  if (error) throw boost::system::system_error(error);
  body_left_ = false;
  request.body = std::move(whole.get().body());
}

asio::awaitable<void> PageConnection::read_record(Head& head, PageRequest& request) {
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
    if (Clock::now() > until) throw Refused(408, "the file took too long to come");
    stream_.expires_after(limits.record_quiet);
    parts.get().body().data = part.data();
    parts.get().body().size = part.size();
    boost::system::error_code error;
    co_await http::async_read(stream_, buffer_, parts, asio::redirect_error(use_awaitable, error));
    if (error && error != http::error::need_buffer) throw boost::system::system_error(error);
    const std::size_t come = part.size() - parts.get().body().size;
    if (request.upload->size() + come > limits.record_bytes) throw record_too_long(limits);
    request.upload->write({part.data(), come});
  }
  body_left_ = false;
}

/// By one of the threads that work.
asio::awaitable<PageAnswer> PageConnection::worked_out(const PageHouse& house,
                                                       std::shared_ptr<const PageRequest> request) {
  try {
    co_return house.options.answer(*request);
  } catch (const Refused& error) {
    co_return error_answer(error.status(), error.what());
  } catch (const lab::BadInput& error) {
    co_return error_answer(400, error.what());
  } catch (const std::bad_alloc&) {
    co_return error_answer(503, "there is not enough memory for this");
  } catch (const std::exception& error) {
    co_return error_answer(500, error.what());
  }
}

asio::awaitable<PageAnswer> PageConnection::work_out(PageRequest request) {
  const auto shared = std::make_shared<const PageRequest>(std::move(request));
  if (house_.options.is_urgent && house_.options.is_urgent(*shared)) {
    stream_.expires_never();
    co_return co_await asio::co_spawn(house_.urgent, worked_out(house_, shared), use_awaitable);
  }
  if (house_.being_answered >= house_.options.limits.waiting_answers)
    co_return error_answer(503, "too much is asked for at once; ask again in a while");
  const Counted counted(house_.being_answered);
  stream_.expires_never();
  co_return co_await asio::co_spawn(house_.workers, worked_out(house_, shared), use_awaitable);
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
