// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/team.hpp"

#include <array>
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <stdexcept>
#include <thread>

using namespace triax::sim;

namespace {

/// Waits until it is so, ten seconds at most; says whether it came to be.
template <class Condition>
bool comes_true(const Condition& condition) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > until) return false;
    std::this_thread::yield();
  }
  return true;
}

}  // namespace

TEST_CASE("Grains: a team does every piece of every round once, work after work", "[threads]") {
  for (const int threads : {1, 2, 3}) {
    Team team(threads);
    REQUIRE(team.size() == threads);
    bool once = true;
    for (int run = 0; run < 300; ++run) {
      const int pieces = 1 + run % Team::kMostPieces;
      const unsigned last = static_cast<unsigned>(run) % 5;
      // Plain numbers: the thread sanitizer sees whether rounds are ordered.
      std::array<int, Team::kMostPieces> done{};
      unsigned rounds = 0;
      team.run({pieces, [&](unsigned round, int k) { done.at(k) += round == rounds ? 1 : 1000; },
                [&](unsigned round) { return ++rounds <= last && round < last; }});
      for (int k = 0; k < Team::kMostPieces; ++k)
        once = once && done.at(k) == (k < pieces ? static_cast<int>(last) + 1 : 0);
    }
    CHECK(once);
  }
}

TEST_CASE("Grains: a round begins when all of the one before is done", "[threads]") {
  Team team(3);
  std::array<int, 4> progress{};
  int sum = 0;
  bool early = false;
  team.run({4,
            [&](unsigned round, int k) {
              if (sum != 4 * static_cast<int>(round)) ++progress.at(k);  // too much: seen below
              ++progress.at(k);
            },
            [&](unsigned round) {
              sum = progress[0] + progress[1] + progress[2] + progress[3];
              early = early || sum != 4 * static_cast<int>(round + 1);
              return round < 2000;
            }});
  CHECK(sum == 4 * 2001);
  CHECK_FALSE(early);
}

TEST_CASE("Grains: a thread that stands still in a piece holds up no other piece", "[threads]") {
  Team team(2);
  std::atomic<int> others{0};
  bool all_others = false;
  team.run({8,
            [&](unsigned, int k) {
              if (k == 0)
                all_others = comes_true([&] { return others == 7; });
              else
                ++others;
            },
            [](unsigned) { return false; }});
  CHECK(all_others);
}

TEST_CASE("Grains: a thread that is a little slower keeps its pieces", "[threads]") {
  using namespace std::chrono_literals;
  Team team(2);
  std::array<std::thread::id, 4> by;
  std::atomic<int> first_half{0};
  bool kept = false;
  team.run({4,
            [&](unsigned, int k) {
              by.at(k) = std::this_thread::get_id();
              if (k < 2) std::this_thread::sleep_for(20ms);
              if (k < 2) ++first_half;
              if (k != 2) return;
              comes_true([&] { return first_half == 2; });
              std::this_thread::sleep_for(2ms);  // time in which the other one could take piece 3
            },
            [&](unsigned round) {
              first_half = 0;
              kept = kept || (by[0] == by[1] && by[2] == by[3] && by[0] != by[2]);
              return !kept && round < 20;
            }});
  CHECK(kept);
}

TEST_CASE("Grains: a team that was never used ends, and refuses rounds without pieces") {
  { const Team idle(4); }
  Team team(2);
  const TeamWork none{0, [](unsigned, int) {}, [](unsigned) { return false; }};
  CHECK_THROWS_AS(team.run(none), std::invalid_argument);
}
