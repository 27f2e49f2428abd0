// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/curves.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/src/sample_tests.hpp"

using namespace triax;
using namespace triax::study;

TEST_CASE("thinning keeps few states, and never loses the peak") {
  auto test = src::test::flow_test();
  CurveThinner thinner(901, 20);
  for (const auto& state : test.curves.states) thinner.add(state);
  const auto kept = thinner.take();
  CHECK(kept.size() <= 20 * 20);
  double q = 0;
  for (const auto& state : kept) q = std::max(q, state.q);
  CHECK(q == Approx(60e3).epsilon(1e-4));
  CHECK(kept.front().reading == 0);
  CHECK(kept.back().reading == 900);
}

TEST_CASE("thinning leaves a steep smooth fall a curve, not the straight line of its two ends") {
  constexpr std::int64_t kScans = 40000;  // 400 in a bucket; q falls within 300 of them
  CurveThinner thinner(kScans, 100);
  for (std::int64_t i = 0; i < kScans; ++i) {
    lab::State state;
    state.reading = i;
    const double fallen = std::clamp(static_cast<double>(i - 20050) / 300, 0.0, 1.0);
    state.q = 100e3 * (1 - fallen * fallen);
    thinner.add(state);
  }
  int within = 0;
  for (const auto& state : thinner.take()) within += state.q > 1e3 && state.q < 99e3 ? 1 : 0;
  CHECK(within >= 5);
}
