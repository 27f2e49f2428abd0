// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/served/axis_orders.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;
using Kind = AxisDemand::Kind;

TEST_CASE("a ramp of force runs over the plant's time and then holds") {
  AxisOrders orders;
  orders.order(
      {.mode = FrameMode::force, .force_from_n = 100, .force_to_n = 200, .force_time_s = 4}, 10);
  const AxisDemand first = orders.demand(10, 1), third = orders.demand(12, 1);
  CHECK(first.kind == Kind::force);
  CHECK(first.start_force_n == 100);
  CHECK(first.force_n == Approx(125));
  CHECK(third.start_force_n == Approx(150));
  CHECK(third.force_n == Approx(175));
  const AxisDemand last = orders.demand(13, 1), after = orders.demand(14, 1);
  CHECK(last.force_n == 200);
  CHECK(after.start_force_n == 200);
  CHECK(after.force_n == 200);
}

TEST_CASE("a perturbation is of the first tick only") {
  AxisOrders orders;
  orders.order(
      {.mode = FrameMode::dead_load, .force_to_n = 50, .impulse_n_s = 2, .perturbed = true}, 0);
  const AxisDemand first = orders.demand(0, 0.25), second = orders.demand(0.25, 0.25);
  CHECK(first.dead);
  CHECK(first.perturbed);
  CHECK(first.impulse_n_s == 2);
  CHECK_FALSE(second.perturbed);
  CHECK(second.impulse_n_s == 0);
  CHECK(second.force_n == 50);
}

TEST_CASE("a frame that has no order, or is stopped, stands; a free one is no axis at all") {
  AxisOrders orders;
  CHECK(orders.demand(0, 1).kind == Kind::crosshead);
  CHECK(orders.demand(0, 1).velocity_m_per_s == 0);
  orders.order({.mode = FrameMode::crosshead, .velocity_m_per_s = 1e-5, .spring_n_per_m = 3e4}, 0);
  CHECK(orders.demand(0, 1).velocity_m_per_s == 1e-5);
  CHECK(orders.demand(0, 1).spring_n_per_m == 3e4);
  orders.order({.mode = FrameMode::stop, .velocity_m_per_s = 1e-5}, 1);
  CHECK(orders.demand(1, 1).velocity_m_per_s == 0);
  orders.order({.mode = FrameMode::free}, 1);
  CHECK(orders.demand(1, 1).kind == Kind::free);
}
