// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/detection/naive_methods.hpp"

#include <catch2/catch.hpp>

using namespace triax;
using bench::Onset;

namespace {

/// q = 100 − (i − top)² along ε₁ = i without volume: dq changes sign between top and top + 1.
lab::State parabola(int i, int top) {
  lab::State s;
  s.reading = i;
  s.strain = {double(i), -double(i) / 2};
  s.volumetric_strain = 0;
  s.q = 100 - (i - top) * (i - top);
  s.p_eff = 50;
  return s;
}

template <class Method>
std::optional<Onset> judge(Method method, int readings, int top) {
  for (int i = 0; i < readings; ++i) method.add(parabola(i, top));
  return method.onset();
}

}  // namespace

TEST_CASE("second-order work of a finite increment: dq dε_q + dp' dε_v") {
  CHECK(bench::second_order_work(3, 5, 0.7, 0.3) == Approx(3 * 0.6 + 5 * 0.3));
}

TEST_CASE("the maximum of q is an onset once a tenth of it is lost") {
  // 100 − 3² = 91 keeps more than nine tenths, 100 − 4² = 84 does not.
  CHECK_FALSE(judge(bench::MaximumOfQ(), 14, 10));
  const auto onset = judge(bench::MaximumOfQ(), 15, 10);
  REQUIRE(onset);
  CHECK(onset->reading == 10);
  CHECK(onset->eta == Approx(2));
}

TEST_CASE("neighbouring increments turn negative at the reading after the top") {
  const auto onset = judge(bench::NeighbouringIncrements(), 20, 10);
  REQUIRE(onset);
  CHECK(onset->reading == 11);
  CHECK_FALSE(judge(bench::NeighbouringIncrements(), 11, 10));
}

TEST_CASE("an increment across two stages is none") {
  bench::NeighbouringIncrements method;
  method.add(parabola(10, 10));
  method.start_stage();
  method.add(parabola(11, 10));
  CHECK_FALSE(method.onset());
}

TEST_CASE("a moving average of 4 sees the same parabola and asks for four in a row") {
  // The averages over i − 4 … i − 1 and i − 3 … i fall once q(i) < q(i − 4): from i = 13 on, whose
  // middle is reading 11; the fourth in a row is complete with reading 16.
  CHECK_FALSE(judge(bench::MovingAverage(4), 16, 10));
  const auto onset = judge(bench::MovingAverage(4), 17, 10);
  REQUIRE(onset);
  CHECK(onset->reading == 11);
}

TEST_CASE("a moving average starts again with each stage") {
  bench::MovingAverage method(4);
  for (int i = 0; i < 40; ++i) {
    if (i % 4 == 0) method.start_stage();
    method.add(parabola(i, 10));
  }
  CHECK_FALSE(method.onset());
}
