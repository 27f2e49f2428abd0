// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/instrument_clocks.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;
using Catch::Contains;

TEST_CASE("a clock that runs as ours is not told, whatever the date on it", "[remote]") {
  InstrumentClocks clocks;
  for (int i = 0; i < 100'000; ++i) {
    const double t = i;
    // The stamp lies anywhere between question and answer, which may take long.
    clocks.take("scanner", 1e9 + t + (i % 7) * 0.1, t, t + 0.7);
    clocks.take("meter", 5 + t * (1 + 5e-6), t, t + 0.7);  // half a second ahead at the end
  }
  CHECK(clocks.news().empty());
}

TEST_CASE("a clock that jumps is told once, with the size of its jump", "[remote]") {
  const double jump_s = GENERATE(3600.0, 7.0, -7.0);
  InstrumentClocks clocks;
  for (int t = 0; t < 100; ++t) clocks.take("scanner", t + (t < 50 ? 0 : jump_s), t, t + 0.1);
  const auto news = clocks.news();
  REQUIRE(news.size() == 1);
  CHECK_THAT(news.front(),
             Contains("scanner clock jumped by " + std::string(jump_s > 0 ? "+" : "-")));
  CHECK(clocks.news().empty());
}

TEST_CASE("a clock that drifts is told with its rate, each doubling once", "[remote]") {
  const double rate = GENERATE(1.01, 0.99);
  InstrumentClocks clocks;
  std::vector<std::string> all;
  for (int t = 0; t <= 1000; ++t) {
    clocks.take("scanner", rate * t, t, t);
    for (auto& one : clocks.news()) all.push_back(std::move(one));
  }
  REQUIRE(all.size() == 4);  // 1, 2, 4 and 8 s of the 10
  CHECK_THAT(all.front(), Contains(rate > 1 ? "runs fast: 1.0 s ahead after 100 s (+1 %)"
                                            : "runs slow: 1.0 s behind after 100 s (-1 %)"));
}
