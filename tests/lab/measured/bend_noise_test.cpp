// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/bend_noise.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/devices/noise.hpp"

using namespace triax::lab;

TEST_CASE("white noise gives its share of the deviation, whatever smooth curve it lies on") {
  const double rms = GENERATE(0.1, 1.0, 30.0);
  const double slope = GENERATE(0.0, 0.01);
  BendNoise noise;
  for (std::uint64_t i = 0; i < 20000; ++i)
    noise.add(slope * static_cast<double>(i) + rms * standard_normal(3, 1, i));
  CHECK(noise.value() == Approx(0.578 * rms).epsilon(0.02));
}

TEST_CASE("a curve without noise has none, however coarse its points; its turns count for little") {
  BendNoise peak;
  for (const double q : {0.0, 25.0, 43.0, 50.0, 52.0, 51.0, 47.0, 40.0, 30.0}) peak.add(q);
  CHECK(peak.value() == 0);
  BendNoise wave;
  for (int i = 0; i < 400; ++i) wave.add(100 * std::sin(0.1 * i));
  CHECK(wave.value() < 0.05);
}

TEST_CASE("of three values nothing is known") {
  BendNoise noise;
  for (const double q : {0.0, 10.0, 0.0}) noise.add(q);
  CHECK(noise.value() == 0);
}

TEST_CASE("across an interruption nothing bends, and what was learnt before stands") {
  BendNoise noise;
  for (std::uint64_t i = 0; i < 2000; ++i) noise.add(standard_normal(3, 1, i));
  const double learnt = noise.value();
  noise.interrupt();
  for (const double q : {500.0, 600.0, 700.0, 800.0}) noise.add(q);
  CHECK(noise.value() == Approx(learnt).epsilon(0.001));
  BendNoise through;
  for (const double q : {0.0, 10.0, 0.0, 500.0, 600.0, 700.0, 800.0}) through.add(q);
  BendNoise apart;
  for (const double q : {0.0, 10.0, 0.0}) apart.add(q);
  apart.interrupt();
  for (const double q : {500.0, 600.0, 700.0, 800.0}) apart.add(q);
  CHECK(through.value() > 0);
  CHECK(apart.value() == 0);
}
