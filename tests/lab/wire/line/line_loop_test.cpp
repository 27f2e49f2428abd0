// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/line/line_loop.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

using triax::lab::LineLoop;

TEST_CASE("LineLoop::take_longest_stall_s: for how long no handler ran", "[wire][line]") {
  LineLoop loop;
  loop.run_for(0.2);
  CHECK(loop.take_longest_stall_s() < 0.15);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  loop.run_for(0.1);
  CHECK(loop.take_longest_stall_s() >= 0.3);
  CHECK(loop.take_longest_stall_s() < 0.15);
}
