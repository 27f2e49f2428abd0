// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/log_axis.hpp"

#include <catch2/catch.hpp>
#include <utility>

#include "src/plot/drawing.hpp"

using namespace triax::src;

TEST_CASE("a logarithmic axis is as long as its data, and two ticks or more have numbers") {
  const auto plot = make_plot(300, 200);
  for (const auto& [low, high] : {std::pair(92.0, 104.0), std::pair(1.2, 330.0),
                                  std::pair(51.0, 99.0), std::pair(0.01, 9000.0)}) {
    INFO(low << " to " << high);
    set_log_axis(*plot->xAxis, low, high);
    const auto range = plot->xAxis->range();
    CHECK(range.lower < low);
    CHECK(range.upper > high);
    if (high > 3 * low) {  // no decade without data
      CHECK(range.lower > low / 1.2);
      CHECK(range.upper < high * 1.2);
    }
    const auto ticker = plot->xAxis->ticker().dynamicCast<QCPAxisTickerText>();
    REQUIRE(ticker);
    CHECK(ticker->ticks().size() >= 2);
    CHECK(ticker->ticks().size() <= 10);
    for (auto at = ticker->ticks().cbegin(); at != ticker->ticks().cend(); ++at)
      CHECK(range.contains(at.key()));
  }
}
