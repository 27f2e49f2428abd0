// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/http/server.hpp"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "lab/base/bad_input.hpp"

using namespace triax;
using namespace triax::src;

namespace {

/// What is wrong with listening there; empty where nothing is.
std::string refusal(std::vector<std::string> listen) {
  try {
    PageServer server({.listen = std::move(listen), .answer = {}});
    return server.port() == 0 ? "no port" : "";
  } catch (const lab::BadInput& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("a name that stands for this machine only is refused, and an address asked for") {
  // A name, not an address, to who reads addresses; the system resolves it to 127.0.0.1 everywhere.
  const std::string told = refusal({"127.1"});
  CHECK(told.find("the computer itself (127.0.0.1)") != std::string::npos);
  CHECK(told.find("give the address") != std::string::npos);
  CHECK(refusal({"127.0.0.1"}).empty());
  CHECK(refusal({"0.0.0.0"}).find("give the name or the address") != std::string::npos);
}

TEST_CASE("two names of one address are listened to once") {
  CHECK(refusal({"localhost", "127.0.0.1"}).empty());
  CHECK(refusal({"127.0.0.1", "127.0.0.1"}).empty());
}

namespace {

using namespace std::chrono_literals;

/// A server that answers requests by their path: "/api/fast" at once, anything else as `slow` does.
struct SlowServer {
  std::function<PageAnswer(const PageRequest&)> slow;
  PageLimits limits;
  PageServer server{{.limits = limits,
                     .queue_of =
                         [](const PageRequest& request) {
                           return request.target.path[1] == "fast" ? WorkQueue::light
                                                                   : WorkQueue::heavy;
                         },
                     .answer =
                         [this](const PageRequest& request) {
                           return request.target.path[1] == "fast" ? PageAnswer{} : slow(request);
                         }}};
  std::string host = "127.0.0.1:" + std::to_string(server.port());
  std::string cookie;

  /// A connection that has sent the text.
  int connection(const std::string& text) const {
    const int client = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(server.port());
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    REQUIRE(::connect(client, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0);
    REQUIRE(::send(client, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size()));
    return client;
  }
  int get(const std::string& target) const {
    return connection("GET " + target + " HTTP/1.1\r\nHost: " + host + "\r\nCookie: " + cookie +
                      "\r\nConnection: close\r\n\r\n");
  }
  static std::string rest(int client) {
    std::string text;
    std::array<char, 4096> part{};
    for (ssize_t count = 0; (count = ::recv(client, part.data(), part.size(), 0)) > 0;)
      text.append(part.data(), static_cast<std::size_t>(count));
    ::close(client);
    return text;
  }
  SlowServer& enter() {
    const std::string address = server.new_address();
    const std::string entered = rest(get(address.substr(address.find("/?"))));
    const auto from = entered.find("triax_");
    cookie = entered.substr(from, entered.find(';', from) - from);
    return *this;
  }
};

PageAnswer wait_until_cancelled(const PageRequest& request) {
  while (!request.is_cancelled()) std::this_thread::sleep_for(5ms);
  throw_if_cancelled(request);
  return {};
}

}  // namespace

TEST_CASE("PageServer: an answer that takes too long ends with 503") {
  PageLimits limits;
  limits.answer_time = 300ms;
  SlowServer page{.slow = wait_until_cancelled, .limits = limits};
  const std::string answer = page.enter().rest(page.get("/api/slow"));
  CHECK(answer.starts_with("HTTP/1.1 503"));
  CHECK(answer.find("Retry-After: ") != std::string::npos);
  CHECK(answer.find("time limit") != std::string::npos);
}

TEST_CASE("PageServer: work ends when its client closes the connection") {
  std::atomic<int> ended = 0;
  SlowServer page{.slow =
                      [&](const PageRequest& request) {
                        while (!request.is_cancelled()) std::this_thread::sleep_for(5ms);
                        ++ended;
                        return PageAnswer{};
                      },
                  .limits = {}};
  const int client = page.enter().get("/api/slow");
  std::this_thread::sleep_for(300ms);
  CHECK(ended == 0);
  ::close(client);
  for (int i = 0; i < 100 && ended == 0; ++i) std::this_thread::sleep_for(10ms);
  CHECK(ended == 1);
}

TEST_CASE("PageServer: light requests do not wait for heavy ones") {
  std::atomic<bool> done = false;
  SlowServer page{.slow =
                      [&](const PageRequest&) {
                        while (!done) std::this_thread::sleep_for(5ms);
                        return PageAnswer{};
                      },
                  .limits = {}};
  page.enter();
  std::vector<int> clients;
  for (int i = 0; i < 20; ++i) clients.push_back(page.get("/api/slow"));
  std::this_thread::sleep_for(200ms);
  CHECK(page.rest(page.get("/api/fast")).starts_with("HTTP/1.1 200"));
  done = true;
  for (const int client : clients) CHECK(page.rest(client).starts_with("HTTP/1.1 200"));
}

TEST_CASE("PageServer: a full queue refuses with Retry-After") {
  std::atomic<bool> done = false;
  PageLimits limits;
  limits.waiting_answers = 2;
  SlowServer page{.slow =
                      [&](const PageRequest&) {
                        while (!done) std::this_thread::sleep_for(5ms);
                        return PageAnswer{};
                      },
                  .limits = limits};
  page.enter();
  const int first = page.get("/api/slow"), second = page.get("/api/slow");
  std::this_thread::sleep_for(200ms);
  const std::string refused = page.rest(page.get("/api/slow"));
  CHECK(refused.starts_with("HTTP/1.1 503"));
  CHECK(refused.find("Retry-After: ") != std::string::npos);
  done = true;
  CHECK(page.rest(first).starts_with("HTTP/1.1 200"));
  CHECK(page.rest(second).starts_with("HTTP/1.1 200"));
}
