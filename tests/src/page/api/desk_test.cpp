// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/api/desk.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <thread>

#include "src/page/request/request.hpp"

using namespace triax::src;

namespace {

std::future<std::string> asked(Desk& desk, std::function<std::string()> work) {
  return std::async(std::launch::async, [&desk, work = std::move(work)] { return desk.ask(work); });
}

/// Works until that answer is there.
std::string answered(Desk& desk, std::future<std::string>& answer) {
  while (answer.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    desk.work_for(std::chrono::milliseconds(1));
  return answer.get();
}

}  // namespace

TEST_CASE("the first thread does what others ask for, and they are told what came of it") {
  Desk desk;
  std::thread::id drawn_by;
  auto drawn = asked(desk, [&drawn_by] {
    drawn_by = std::this_thread::get_id();
    return std::string("figure");
  });
  CHECK(answered(desk, drawn) == "figure");
  CHECK(drawn_by == std::this_thread::get_id());
  auto failed = asked(desk, []() -> std::string { throw std::runtime_error("no font"); });
  CHECK_THROWS_WITH(answered(desk, failed), "no font");
  desk.work_for(std::chrono::milliseconds(1));  // nothing waits
}

TEST_CASE("who waits when nobody works any longer is told so") {
  Desk desk;
  auto waiting = asked(desk, [] { return std::string(); });
  desk.close();  // before it asks, or while it waits
  CHECK_THROWS_AS(waiting.get(), Refused);
  CHECK_THROWS_AS(desk.ask([] { return std::string(); }), Refused);
}
