// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/team.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <numeric>

using namespace triax::sim;

TEST_CASE("Grains: a team runs a task once in each thread, again and again", "[threads]") {
  Team team(3);
  REQUIRE(team.size() == 3);
  std::array<int, 3> runs{};
  for (int r = 0; r < 200; ++r) team.run([&](int thread) { ++runs.at(thread); });
  CHECK(runs == std::array<int, 3>{200, 200, 200});
}

TEST_CASE("Grains: nobody passes a meeting point before all are there", "[threads]") {
  Team team(3);
  MeetingPoint all(3);
  std::array<std::atomic<int>, 3> progress{};
  std::atomic<int> early{0};
  team.run([&](int thread) {
    for (int r = 1; r <= 500; ++r) {
      progress.at(thread) = r;
      all.wait();
      for (const auto& p : progress)
        if (p < r) ++early;
      all.wait();
    }
  });
  CHECK(early == 0);
}
