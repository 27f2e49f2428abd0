// SPDX-License-Identifier: GPL-3.0-or-later
// The loops of an elastic sensing element: closed forms of the superposed plays, and what a data
// sheet says of them.
#include "lab/devices/hysteresis.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax;

namespace {

constexpr double kRange = 1000, kHalf = 0.5;

/// An element after it went from rest at 0 to `top`, and back to 0.
lab::Hysteresis cycled(double top) {
  lab::Hysteresis element;
  element.rest_at(0);
  element.follow(top, kHalf, kRange);
  element.follow(0, kHalf, kRange);
  return element;
}

/// Falling less rising reading at x over a cycle between 0 and `top`.
double width(double top, double x) {
  lab::Hysteresis element = cycled(top);
  const double rising = element.follow(x, kHalf, kRange);
  element.follow(top, kHalf, kRange);
  return element.follow(x, kHalf, kRange) - rising;
}

}  // namespace

TEST_CASE("over full scale the loop is widest in the middle, by what the data sheet says") {
  CHECK(width(kRange, kRange / 2) == Approx(2 * kHalf));
  CHECK(width(kRange, 0) == Approx(0).margin(1e-9));
  CHECK(width(kRange, kRange) == Approx(0).margin(1e-9));
  for (double x = 0; x <= kRange; x += 37) {
    CHECK(width(kRange, x) <= 2 * kHalf + 1e-9);
    CHECK(width(kRange, x) >= -1e-9);
  }
}

TEST_CASE("the width of a loop grows with the square of its amplitude") {
  CHECK(width(kRange / 2, kRange / 4) == Approx(2 * kHalf / 4));
  CHECK(width(kRange / 50, kRange / 100) == Approx(0).margin(1e-9));
}

TEST_CASE("a small turn is seen at once, smaller by seven times h over the range") {
  lab::Hysteresis element = cycled(kRange);
  const double top = element.follow(400, kHalf, kRange);
  const double back = element.follow(399.9, kHalf, kRange);
  CHECK(top - back == Approx(0.1 * (1 - 7 * kHalf / kRange)));
}

TEST_CASE("a loop that closes is forgotten") {
  lab::Hysteresis straight = cycled(kRange), looped = straight;
  looped.follow(600, kHalf, kRange);
  looped.follow(350, kHalf, kRange);
  CHECK_FALSE(looped == straight);
  looped.follow(600, kHalf, kRange);
  straight.follow(600, kHalf, kRange);
  CHECK(looped.follow(800, kHalf, kRange) == Approx(straight.follow(800, kHalf, kRange)));
}

TEST_CASE("at rest, and without hysteresis, nothing is changed, to the bit") {
  lab::Hysteresis element;
  element.rest_at(123.456);
  CHECK(element.follow(123.456, kHalf, kRange) == 123.456);
  CHECK(element.follow(std::sqrt(2.0), 0, 0) == std::sqrt(2.0));
}
