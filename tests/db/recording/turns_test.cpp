// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/turns.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <thread>
#include <vector>

using triax::db::Turns;

TEST_CASE("turns are taken in order, whichever thread comes first", "[threads]") {
  Turns turns;
  std::vector<int> order;
  {
    std::vector<std::jthread> threads;
    for (int number = 20; number >= 1; --number)
      threads.emplace_back([&, number] {
        if (number % 5 == 0) return turns.over(number);  // never taken
        turns.wait_for(number);
        order.push_back(number);
        turns.over(number);
        turns.over(number);
      });
  }
  CHECK(order.size() == 16);
  CHECK(std::is_sorted(order.begin(), order.end()));
}
