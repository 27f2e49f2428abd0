// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/loading_frame.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("a frame gives velocities of its range, either way") {
  LoadingFrame frame;
  frame.slowest_m_per_s = 1e-7;
  frame.fastest_m_per_s = 1e-4;
  CHECK(gives(frame, 1e-4));
  CHECK(gives(frame, -1e-4));
  CHECK(gives(frame, 1e-4 * (1 + 1e-15)));
  CHECK_FALSE(gives(frame, 1.01e-4));
  CHECK_FALSE(gives(frame, 0.9e-7));
}

TEST_CASE("a frame takes the nearest whole step of velocity, never none") {
  LoadingFrame frame;
  CHECK(given_velocity(frame, 1.23456e-6) == 1.23456e-6);
  frame.velocity_step_m_per_s = 1e-7;
  CHECK(given_velocity(frame, 1.23456e-6) == Approx(1.2e-6).epsilon(1e-14));
  CHECK(given_velocity(frame, -1.26e-6) == Approx(-1.3e-6).epsilon(1e-14));
  CHECK(given_velocity(frame, 1e-9) == 1e-7);
  CHECK(given_velocity(frame, 0) == 0);
}
