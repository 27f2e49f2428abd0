// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/force_cylinder.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace triax::lab;

TEST_CASE("a force servo without a bandwidth follows at once, to the bit") {
  ForceCylinderState state{100};
  advance({}, state, 100, 123.456, 0.25);
  CHECK(state.force_n == 123.456);
}

TEST_CASE("a force servo answers a step with its bandwidth and lags a ramp by rate/(2 pi f)") {
  LoadingFrame frame;
  frame.bandwidth_hz = 0.5;
  CHECK(servo_time_constant_s(frame) == Approx(1 / std::numbers::pi));
  ForceCylinderState state;
  advance(frame, state, 200, 200, 0.25);
  CHECK(state.force_n == Approx(200 * (1 - std::exp(-0.25 * std::numbers::pi))).epsilon(1e-14));
  state.force_n = 0;
  for (int i = 0; i < 400; ++i) advance(frame, state, 2.5 * i, 2.5 * (i + 1), 0.25);
  CHECK(1000 - state.force_n == Approx(10 / std::numbers::pi).epsilon(1e-10));
}

TEST_CASE("at its bandwidth the servo passes a sine with 1/sqrt 2 of its height") {
  LoadingFrame frame;
  frame.bandwidth_hz = 2;
  ForceCylinderState state;
  constexpr double kDt = 1e-4;
  const auto wanted = [](double t) { return std::sin(2 * std::numbers::pi * 2 * t); };
  double highest = 0;
  for (int i = 0; i < 30000; ++i) {
    advance(frame, state, wanted(i * kDt), wanted((i + 1) * kDt), kDt);
    if (i > 20000) highest = std::max(highest, state.force_n);
  }
  CHECK(highest == Approx(1 / std::numbers::sqrt2).epsilon(1e-5));
}
