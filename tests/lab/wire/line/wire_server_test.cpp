// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/line/wire_server.hpp"

#include <catch2/catch.hpp>

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
