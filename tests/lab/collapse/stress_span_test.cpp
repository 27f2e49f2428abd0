// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/stress_span.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace triax::lab;

TEST_CASE("without a stretch the interval is that of the measured state alone") {
  const StressInterval at = StressSpan(60e3, 100e3).interval({.q = 1e3, .p_eff = 2e3, .eta = 0.01});
  CHECK(at.q_pa.low == Approx(60e3 - 2.2e3));
  CHECK(at.q_pa.high == Approx(60e3 + 2.2e3));
  CHECK(at.p_eff_pa.high == Approx(104.4e3));
  CHECK(at.eta.low == Approx(0.6 - 0.022));
  CHECK(at.eta.high == Approx(0.6 + 0.022));
}

TEST_CASE("what the path does and the error of the state add as squares, to each side by itself") {
  StressSpan span(60e3, 100e3);
  span.reach(63e3, 90e3);  // η 0.7
  const StressInterval at = span.interval({.q = 4e3 / 2.2, .p_eff = 0, .eta = 0});
  CHECK(at.q_pa.high == Approx(60e3 + 5e3));  // 3² + 4² = 5²
  CHECK(at.q_pa.low == Approx(60e3 - 4e3));
  CHECK(at.p_eff_pa.low == Approx(90e3));
  CHECK(at.p_eff_pa.high == Approx(100e3));
  CHECK(at.eta.low == Approx(0.6));
  CHECK(at.eta.high == Approx(0.7));
}

TEST_CASE("a liquefied state reaches to the ratio at which the lateral stress is zero") {
  StressSpan span(60e3, 100e3);
  span.reach(50, -20);
  CHECK(span.interval({}).eta.high == Approx(3));
  span.reach(std::nan(""), 10e3);  // unknown: no state at all
  CHECK(span.interval({}).q_pa.low == Approx(50));
}

TEST_CASE("a hull holds both intervals") {
  const StressInterval both = hull(as_interval(60e3, 100e3), as_interval(50e3, 125e3));
  CHECK(both.q_pa.low == 50e3);
  CHECK(both.q_pa.high == 60e3);
  CHECK(both.p_eff_pa.high == 125e3);
  CHECK(both.eta.low == Approx(0.4));
  CHECK(both.eta.high == Approx(0.6));
}

TEST_CASE("single readings may each have all of the variance of (p', q) as a vector") {
  // 3 σ_p² + ⅔ σ_q² with σ_p = 0 or σ_q = 0.
  const StressError error = error_of_readings(6e6, 60e3, 100e3);
  CHECK(error.q == Approx(3e3));
  CHECK(error.p_eff == Approx(std::sqrt(2e6)));
  CHECK(error.eta == Approx(std::hypot(3e3, 0.6 * std::sqrt(2e6)) / 100e3));
}
