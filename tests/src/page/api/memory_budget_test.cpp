// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/api/memory_budget.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <utility>

using triax::src::MemoryBudget;

TEST_CASE("shares are given until the budget is taken, and come back") {
  MemoryBudget budget(100);
  auto first = budget.take(60);
  CHECK(first);
  CHECK_FALSE(budget.take(41));
  CHECK_FALSE(budget.take(std::numeric_limits<std::size_t>::max()));
  {
    const auto second = budget.take(40);
    CHECK(second);
    CHECK(budget.taken() == 100);
  }
  CHECK(budget.taken() == 60);
  auto moved = std::move(first);
  CHECK(budget.taken() == 60);
  moved = budget.take(10);
  CHECK(budget.taken() == 10);
  {
    MemoryBudget::Share grown;
    grown.add(budget.take(20));
    grown.add(budget.take(30));
    grown.add({});
    CHECK(budget.taken() == 60);
  }
  CHECK(budget.taken() == 10);
}
