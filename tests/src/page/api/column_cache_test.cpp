// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/api/column_cache.hpp"

#include <catch2/catch.hpp>

#include "src/page/request/request.hpp"

using namespace triax;
using namespace triax::src;

namespace {

/// A cache for 100 bytes, asked without a database.
struct Cached {
  MemoryBudget budget{100};
  ColumnCache cache{budget};

  template <class Use>
  void with(std::int64_t test, std::size_t bytes, const Use& use, const char* version = "1") {
    cache.with(
        test, version, [bytes](const study::TestColumns&) { return bytes; },
        [&use](study::TestColumns&) { use(); });
  }
  void with(std::int64_t test, std::size_t bytes, const char* version = "1") {
    with(
        test, bytes, [] {}, version);
  }
  unsigned refusal(std::int64_t test, std::size_t bytes) {
    try {
      with(test, bytes);
    } catch (const Refused& refused) {
      return refused.status();
    }
    return 0;
  }
};

}  // namespace

TEST_CASE("tests that nobody asked for lately make room") {
  Cached kept;
  kept.with(1, 40);
  kept.with(2, 40);
  CHECK(kept.budget.taken() == 80);
  kept.with(1, 40);  // asked for later than the other
  kept.with(3, 50);
  CHECK(kept.budget.taken() == 90);
  kept.with(1, 50);  // more of one: what it has already counts
  CHECK(kept.budget.taken() == 100);
  kept.with(1, 10, "2");  // another test by that number
  CHECK(kept.budget.taken() == 60);
  CHECK(kept.refusal(4, 101) == 413);
}

TEST_CASE("where there is no room for more, what is held stays paid for") {
  Cached kept;
  kept.with(2, 30);
  kept.with(1, 60, [&] {
    CHECK(kept.refusal(2, 50) == 503);
    CHECK(kept.refusal(3, 50) == 503);
    CHECK(kept.budget.taken() == 60);  // the second made room, in vain, for the third
    CHECK(kept.refusal(2, 30) == 0);
    CHECK(kept.budget.taken() == 90);
    CHECK(kept.refusal(2, 50) == 503);
    CHECK(kept.budget.taken() == 90);
  });
  CHECK(kept.refusal(2, 100) == 0);
  CHECK(kept.budget.taken() == 100);
}
