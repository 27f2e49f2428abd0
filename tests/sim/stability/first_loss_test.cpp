#include "sim/stability/first_loss.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::sim;

TEST_CASE("the first zero along a line, in either direction") {
  const Criterion wave = [](double x) { return std::cos(x); };
  CHECK(first_loss(wave, 0, 10).value() == Approx(std::acos(0)).epsilon(1e-11));
  CHECK(first_loss(wave, 6, 0).value() == Approx(3 * std::acos(0)).epsilon(1e-11));
  CHECK(first_loss(wave, 2, 10) == 2.0);
  CHECK_FALSE(first_loss(wave, 0, 1.5));
}

TEST_CASE("a place without a value counts as holding") {
  const Criterion gap = [](double x) {
    return x < 0.5 ? std::optional<double>() : std::optional(0.75 - x);
  };
  CHECK(first_loss(gap, 0, 1).value() == Approx(0.75).epsilon(1e-11));
  const Criterion nowhere = [](double) { return std::optional<double>(); };
  CHECK_FALSE(first_loss(nowhere, 0, 1));
}
