// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/channel_noise.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/devices/noise.hpp"

using triax::lab::ChannelNoise;
using triax::lab::standard_normal;

namespace {

constexpr double kFinest = 1e-9;

/// A ramp with white noise through a converter of step 1.
double quantised(double ramp, double rms, std::uint64_t i) {
  return std::round(ramp * double(i) + rms * standard_normal(7, 1, i));
}

ChannelNoise learned(double ramp, double rms, int n) {
  ChannelNoise noise(kFinest);
  for (int i = 0; i < n; ++i) noise.add(quantised(ramp, rms, std::uint64_t(i)));
  return noise;
}

}  // namespace

TEST_CASE("white noise at rest and on a ramp is seen as what moves the channel") {
  for (double rms : {1.5, 5.0, 50.0})
    for (double ramp : {0.0, 0.7, 3.0}) {
      const ChannelNoise noise = learned(ramp, rms, 1000);
      INFO("rms " << rms << " ramp " << ramp);
      CHECK(noise.dithers());
      REQUIRE(noise.impossible_run());
      CHECK(*noise.impossible_run() >= 30);
      CHECK(*noise.impossible_run() <= 60);
      // E|x − (x₋ + x₊)/2| = √(3/2) σ √(2/π)
      CHECK(noise.roughness() == Approx(std::sqrt(3 / M_PI) * std::hypot(rms, 0.29)).epsilon(0.2));
    }
}

TEST_CASE("the wait follows the share f of equal neighbours: ln(1e-9)/ln f") {
  // ±: the value moves to and fro and rests in between, so that two in four neighbours are equal;
  // now and then by two steps.
  ChannelNoise noise(kFinest);
  for (int i = 0; i < 4000; ++i) noise.add((i / 2) % 2 == 0 ? 0 : (i / 2) % 8 == 1 ? 2 : 1);
  REQUIRE(noise.impossible_run());
  // f is known to three errors of 256 neighbours: ½ + 3·√(¼/256)
  CHECK(double(*noise.impossible_run()) ==
        Approx(std::log(1e-9) / std::log(0.5 + 3 * std::sqrt(0.25 / 256))).margin(3));
}

TEST_CASE("a flicker between two neighbouring values may rest as soon as its mean lies between") {
  ChannelNoise noise(kFinest);
  for (int i = 0; i < 4000; ++i) noise.add((i / 2) % 2);
  CHECK_FALSE(noise.impossible_run());
  // 0.3 steps rms on a slow ramp: it flickers at each flip and rests in between.
  CHECK_FALSE(learned(0.002, 0.3, 4000).impossible_run());
}

TEST_CASE("what moves without noise may rest: ramps, smooth or in steps, and constants") {
  for (double ramp : {0.0, 0.013, 0.4, 3.7}) {
    const ChannelNoise noise = learned(ramp, 0, 2000);
    INFO("ramp " << ramp);
    CHECK_FALSE(noise.dithers());
    CHECK_FALSE(noise.impossible_run());
  }
  ChannelNoise smooth(kFinest);
  for (int i = 0; i < 2000; ++i) smooth.add(std::sin(i * 1e-2));
  CHECK_FALSE(smooth.dithers());
}

TEST_CASE("round-off is no noise") {
  ChannelNoise noise(kFinest);
  for (int i = 0; i < 2000; ++i) noise.add(1e-13 * double(i % 3));
  CHECK_FALSE(noise.dithers());
  CHECK(noise.run() == 1999);
  CHECK(noise.resolution() == kFinest);
}

TEST_CASE("a sluggish channel, mostly at rest, is never believed to be stuck") {
  ChannelNoise noise(kFinest);
  for (int i = 0; i < 5000; ++i) noise.add((i / 40) % 2);
  CHECK_FALSE(noise.impossible_run());
}

TEST_CASE("nothing is said of the first forty neighbours, and outliers do not roughen") {
  CHECK_FALSE(learned(0, 5, 40).dithers());
  ChannelNoise noise = learned(0, 5, 1000);
  const double before = noise.roughness();
  noise.add(1e6);
  noise.add(0);
  noise.add(0.5);
  CHECK(noise.roughness() < 1.1 * before);
}
