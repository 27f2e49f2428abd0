// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/local_fit.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace triax::lab;

TEST_CASE("a parabola is recovered exactly, without scatter") {
  BlockPyramid pyramid;
  for (int i = 0; i < 7; ++i) {
    PathSample s;
    const double x = i - 3;
    s.signal[PathSample::q] = 5e3 + 200 * x - 30 * x * x;
    s.signal[PathSample::axial_strain] = 1e-3 * x;
    pyramid.add(s);
  }
  const LocalFit fit = fit_window(pyramid, 0);
  CHECK(fit.value[PathSample::q] == Approx(5e3));
  CHECK(fit.slope[PathSample::q] == Approx(200));
  CHECK(fit.curvature[PathSample::q] == Approx(-30));
  CHECK(fit.variance[PathSample::q] == Approx(0).margin(1e-6));
  CHECK(fit.slope[PathSample::axial_strain] == Approx(1e-3));
}

TEST_CASE("scatter is unbiased and the slope's variance is 1/28 of it") {
  std::mt19937_64 rng(6);
  std::normal_distribution<double> noise(0, 2);
  double variance = 0, slope_square = 0;
  constexpr int kTrials = 20000;
  for (int trial = 0; trial < kTrials; ++trial) {
    BlockPyramid pyramid;
    for (int i = 0; i < 7; ++i) {
      PathSample s;
      s.signal[PathSample::q] = noise(rng);
      pyramid.add(s);
    }
    const LocalFit fit = fit_window(pyramid, 0);
    variance += fit.variance[PathSample::q] / kTrials;
    slope_square += fit.slope[PathSample::q] * fit.slope[PathSample::q] / kTrials;
  }
  CHECK(variance == Approx(4).epsilon(0.03));
  CHECK(slope_square == Approx(4 * LocalFit::kSlopeFactor).epsilon(0.05));
}
