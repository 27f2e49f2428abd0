// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/onset_fit.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace triax::lab;

namespace {

constexpr double kTopOfSamples = 103.4;

/// Undrained: q = q_top − c (t − t_top)² while ε₁ and u grow evenly; p′ falls.
std::vector<PathSample> undrained(int readings, double noise, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  std::normal_distribution<double> unit(0, 1);
  std::vector<PathSample> samples(static_cast<std::size_t>(readings));
  for (int i = 0; i < readings; ++i) {
    auto& s = samples[static_cast<std::size_t>(i)].signal;
    s[PathSample::reading] = i;
    s[PathSample::progress] = 2.0 * i;
    s[PathSample::q] = 100e3 - 2 * (i - kTopOfSamples) * (i - kTopOfSamples) + noise * unit(rng);
    s[PathSample::p_eff] = 200e3 - 300.0 * i + noise * unit(rng);
    s[PathSample::axial_strain] = 2e-5 * i;
    s[PathSample::pore_pressure] = 300e3 + 300.0 * i;
  }
  return samples;
}

/// At held q: ε_v (and u, its gauge) pass a minimum at kTopOfSamples while p′ falls.
std::vector<PathSample> held_q(double step) {
  auto samples = undrained(200, 0, 1);
  for (auto& sample : samples) {
    auto& s = sample.signal;
    const double t = s[PathSample::reading] - kTopOfSamples;
    s[PathSample::q] = 60e3;
    const double minimum = 1e-8 * t * t;
    s[PathSample::volumetric_strain] = step > 0 ? std::round(minimum / step) * step : minimum;
    s[PathSample::pore_pressure] = 300e3 + 0.5 * t * t;
  }
  return samples;
}

}  // namespace

TEST_CASE("without noise the turn of a parabola is exact, and so are the values there") {
  const auto fit = fit_onset(undrained(200, 0, 1), Witness::second_order_work, 100);
  REQUIRE(fit);
  CHECK(fit->point.reading == Approx(kTopOfSamples).margin(1e-6));
  CHECK(fit->point.progress == Approx(2 * kTopOfSamples));
  CHECK(fit->point.q == Approx(100e3));
  CHECK(fit->point.p_eff == Approx(200e3 - 300 * kTopOfSamples));
  CHECK(fit->error < 1e-3);
}

TEST_CASE("at held q volume and pore pressure each tell") {
  for (const Witness witness : {Witness::volume, Witness::pore_pressure}) {
    const auto fit = fit_onset(held_q(0), witness, 100);
    REQUIRE(fit);
    CHECK(fit->point.reading == Approx(kTopOfSamples).margin(1e-6));
  }
}

TEST_CASE("a volume in steps of a tenth of its change places the minimum within few readings") {
  const auto fit = fit_onset(held_q(1e-5), Witness::volume, 100);
  REQUIRE(fit);
  CHECK(std::abs(fit->point.reading - kTopOfSamples) < 5);
  CHECK(fit->error > 0.1);  // and the fit knows that it is not exact
}

TEST_CASE("the error told is the scatter found, over seeds") {
  double square = 0, told = 0;
  constexpr int kSeeds = 200;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const auto fit =
        fit_onset(undrained(200, 300, std::uint64_t(seed)), Witness::second_order_work, 100);
    REQUIRE(fit);
    square += std::pow(fit->point.reading - kTopOfSamples, 2) / kSeeds;
    told += fit->error / kSeeds;
  }
  CHECK(told / std::sqrt(square) > 0.7);
  CHECK(told / std::sqrt(square) < 1.6);
}

TEST_CASE("no turn, or too few blocks: nothing is made up") {
  auto rising = undrained(200, 0, 1);
  for (auto& s : rising) s.signal[PathSample::q] = 100 * s.signal[PathSample::reading];
  CHECK_FALSE(fit_onset(rising, Witness::second_order_work, 100));
  CHECK_FALSE(fit_onset(undrained(20, 0, 1), Witness::second_order_work, 10));
}

TEST_CASE("values around a reading follow the path through its noise") {
  const PathPoint p = values_at(undrained(200, 100, 3), kTopOfSamples);
  CHECK(p.q == Approx(100e3).margin(60));
  CHECK(p.reading == Approx(kTopOfSamples));
}
