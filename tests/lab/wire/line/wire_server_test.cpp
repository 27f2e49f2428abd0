// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/line/wire_server.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <list>

#include "lab/base/bad_input.hpp"
#include "tests/lab/wire/line/echo.hpp"

using namespace triax::lab;
using namespace triax::wire_tests;

TEST_CASE("a conversation is told of the silence it waits for, and is closed when it is over") {
  EchoLine echo;
  REQUIRE(echo.open() == "");
  Exchange unended = question("");
  unended.request = "12";
  const Asked asked = echo.ask(unended);
  CHECK(asked.values == std::vector{12.0});
  CHECK(asked.answered_s - asked.sent_s > 0.019);
  std::string lost;
  echo.line.on_lost([&](const std::string& why) { lost = why; });
  echo.ask("bye");
  CHECK(echo.loop.run_until([&] { return !lost.empty(); }, echo.loop.now_s() + 1));
  CHECK(lost == "closed by the other side");
  const auto gone = [&] { return echo.server.clients(echo.link) == 0; };
  CHECK(echo.loop.run_until(gone, echo.loop.now_s() + 1));
}

TEST_CASE("a client over the limit is turned away, and one that is idle is closed") {
  EchoLine echo({.clients = 2, .idle_s = 0.2});
  Line second(echo.loop, echo.link), third(echo.loop, echo.link);
  REQUIRE(echo.open() == "");
  int lost = 0;
  for (Line* line : {&second, &third}) {
    line->open(echo.loop.now_s() + 1, {});
    line->on_lost([&](const std::string&) { ++lost; });
  }
  CHECK(echo.loop.run_until([&] { return lost == 1; }, echo.loop.now_s() + 1));
  CHECK(echo.server.clients(echo.link) == 2);
  CHECK(echo.server.turned_away(echo.link) == 1);
  CHECK(echo.loop.run_until([&] { return lost == 2; }, echo.loop.now_s() + 1));
  CHECK(echo.server.clients(echo.link) == 0);
}

namespace {

sockaddr_in on_this_machine(int port) {
  return {.sin_family = AF_INET,
          .sin_port = htons(static_cast<std::uint16_t>(port)),
          .sin_addr = {htonl(INADDR_LOOPBACK)}};
}

/// 0, or why a stranger who asks for that port does not get it.
int taking(int port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  const sockaddr_in address = on_this_machine(port);
  const int failed = ::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address);
  const int why = failed ? errno : 0;
  ::close(socket);
  return why;
}

}  // namespace

TEST_CASE("while clients are refused the port is nobody else's, and is heard again") {
  EchoLine echo;
  REQUIRE(echo.open() == "");
  echo.server.set_fault(echo.link, WireFault::refuse);
  CHECK_THAT(echo.open(), Catch::Contains("refused"));
  CHECK(taking(echo.link.port) == EADDRINUSE);
  echo.server.set_fault(echo.link, WireFault::none);
  REQUIRE(echo.open() == "");
  CHECK(echo.ask("7").values == std::vector{7.0});
  CHECK(taking(echo.link.port) == EADDRINUSE);
}

#ifndef __has_feature
#define __has_feature(feature) 0
#endif

namespace {
[[maybe_unused]] std::size_t resident_kB() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmRSS:")) return std::stoul(line.substr(6));
  return 0;
}
}  // namespace

TEST_CASE("thousands of connections, long lines and slow senders delay nobody and cost nothing") {
  EchoLine echo({.clients = 300});
  REQUIRE(echo.open() == "");
  REQUIRE(echo.ask("1").values == std::vector{1.0});
  double worst_s = 0;
  const auto ask_some = [&] {
    for (int i = 0; i < 20; ++i) {
      const Asked asked = echo.ask("2", 1);
      CHECK(asked.values == std::vector{2.0});
      worst_s = std::max(worst_s, asked.answered_s - asked.sent_s);
    }
  };
  ask_some();
  std::list<Line> others;
  const auto open_others = [&] {
    for (int i = 0; i < 250; ++i) others.emplace_back(echo.loop, echo.link).open(1e9, {});
    ask_some();
  };
  open_others();
  [[maybe_unused]] const std::size_t before_kB = resident_kB();
  for (int round = 0; round < 8; ++round) {
    others.clear();
    open_others();
    // A line of 1 MB without an end, and one byte at a time.
    Exchange flood = question(std::string(1 << 20, 'x'));
    flood.answered = false;
    others.front().ask(flood, 1e9, [](const Asked&) {});
    others.back().ask({.request = "y", .answered = false}, 1e9, [](const Asked&) {});
    ask_some();
  }
  CHECK(worst_s < 1);
#if !defined(__SANITIZE_ADDRESS__) && \
    !__has_feature(address_sanitizer)  // which keeps what is freed
  CHECK(resident_kB() < before_kB + 8192);
#endif
}

TEST_CASE("a client that takes no answers is asked no more, and is closed when it is idle") {
  EchoLine echo({.idle_s = 3});
  REQUIRE(echo.open() == "");
  // Nobody reads on this socket but the system.
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
  // Small buffers of the system, so that what is sent is what our server took.
  const int buffer = 1 << 16;
  for (const int which : {SO_SNDBUF, SO_RCVBUF})
    ::setsockopt(socket, SOL_SOCKET, which, &buffer, sizeof buffer);
  const sockaddr_in address = on_this_machine(echo.link.port);
  ::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address);
  echo.loop.run_for(0.05);
  CHECK(echo.server.clients(echo.link) == 2);
  const std::string questions(std::size_t{1} << 16, '\n');
  std::size_t sent = 0;
  for (int i = 0; i < 1000; ++i) {
    const ssize_t count = ::send(socket, questions.data(), questions.size(), MSG_NOSIGNAL);
    if (count > 0) sent += static_cast<std::size_t>(count);
    if (i % 50 == 0) CHECK(echo.ask("1", 2).values == std::vector{1.0});
    echo.loop.run_for(0.0005);
  }
  CHECK(sent < std::size_t{40} << 20);  // of 64 MB
  CHECK(echo.server.clients(echo.link) == 2);
  for (int i = 0; i < 45; ++i) {
    echo.loop.run_for(0.1);
    CHECK(echo.ask("1", 2).values == std::vector{1.0});
  }
  CHECK(echo.server.clients(echo.link) == 1);
  ::close(socket);
}

TEST_CASE("a serial line is served over a pseudo-terminal, and taken up again after it was lost") {
  const auto make_terminal = [] {
    const int master = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    ::grantpt(master);
    ::unlockpt(master);
    return master;
  };
  const int master = make_terminal();
  const std::string path = ::ptsname(master);
  LineLoop loop;
  WireServer server(loop);
  LinkAddress link = parse_link("serial://" + path + "?baud=19200&parity=even");
  CHECK_THROWS_AS(server.listen(parse_link("serial:///dev/none"), {}), WorkFailed);
  server.listen(link, [] { return std::make_unique<Echo>(); });
  CHECK(server.clients(link) == 1);
  const auto answer = [&loop](int terminal, const std::string& text) {
    CHECK(::write(terminal, text.data(), text.size()) == std::ssize(text));
    loop.run_for(0.1);
    char buffer[100];
    const ssize_t count = ::read(terminal, buffer, sizeof buffer);
    return count > 0 ? std::string(buffer, static_cast<std::size_t>(count)) : "";
  };
  CHECK(answer(master, "SS\n") == "= SS\n");
  server.set_fault(link, WireFault::refuse);
  CHECK(answer(master, "SS\n") == "");
  server.set_fault(link, WireFault::none);
  CHECK(answer(master, "SS\n") == "= SS\n");
  ::close(master);
  loop.run_for(0.1);
  CHECK(server.clients(link) == 0);
}
