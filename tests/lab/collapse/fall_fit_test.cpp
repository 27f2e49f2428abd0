// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/fall_fit.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

using namespace triax::lab;

namespace {

constexpr double kCritical = 0.01;  ///< ε at the limit point
constexpr double kFall = 100.3;     ///< reading of it

/// Equilibrium that ends at a limit point: ε = ε_c − 2e-4 √(t_c − t); q rises with t, or passes its
/// peak at `peak`.
std::vector<PathSample> before_fall(std::optional<double> peak, double noise = 0) {
  std::mt19937_64 rng(3);
  std::normal_distribution<double> unit(0, 1);
  std::vector<PathSample> samples;
  for (int i = 76; i <= 100; ++i) {
    PathSample sample;
    auto& s = sample.signal;
    const double strain = kCritical - 2e-4 * std::sqrt(kFall - i);
    s[PathSample::reading] = i;
    s[PathSample::progress] = 2.0 * i;
    s[PathSample::axial_strain] = strain;
    const double off = (strain - peak.value_or(0)) / 1e-4;
    s[PathSample::q] = (peak ? 50e3 - 10 * off * off : 40e3 + 100.0 * i) + noise * unit(rng);
    s[PathSample::p_eff] = 100e3 - 1e6 * (strain - kCritical);
    s[PathSample::volumetric_strain] = 0;
    s[PathSample::pore_pressure] = 300e3;
    samples.push_back(sample);
  }
  return samples;
}

}  // namespace

TEST_CASE("the limit point of a load is found between the last reading and the fall") {
  const auto fit = fit_fall(before_fall(std::nullopt), false);
  REQUIRE(fit);
  CHECK(fit->reading == 100);
  CHECK(fit->progress == Approx(2 * kFall));
  CHECK(fit->axial_strain == Approx(kCritical));
  CHECK(fit->p_eff == Approx(100e3));
  CHECK(fit->q == Approx(40e3 + 100 * kFall));
}

TEST_CASE("half an interval beyond the last reading is the most that is believed") {
  auto samples = before_fall(std::nullopt);
  samples.pop_back();
  const auto fit = fit_fall(samples, false);
  REQUIRE(fit);
  CHECK(fit->progress == Approx(2 * 99.5));
  CHECK(fit->axial_strain == Approx(kCritical - 2e-4 * std::sqrt(kFall - 99.5)));
}

TEST_CASE("a peak of q before the fall is the onset, unless q was held") {
  const double peak = kCritical - 6e-4;  // 9 readings before the limit point
  const auto fit = fit_fall(before_fall(peak), false);
  REQUIRE(fit);
  CHECK(fit->axial_strain == Approx(peak));
  CHECK(fit->reading == Approx(kFall - 9).margin(1));
  CHECK(fit->q == Approx(50e3));
  CHECK(fit_fall(before_fall(peak), true)->axial_strain == Approx(kCritical));
  CHECK(fit_fall(before_fall(peak, 20), false)->axial_strain == Approx(peak).margin(5e-5));
}

TEST_CASE("too few readings, or readings that do not curve that way, tell nothing") {
  const auto samples = before_fall(std::nullopt);
  CHECK_FALSE(fit_fall(std::span(samples).last(7), false));
  auto straight = samples;
  for (auto& s : straight)
    s.signal[PathSample::axial_strain] =
        1e-9 * std::pow(s.signal[PathSample::reading] - 70, 0.5) * 1e3;
  CHECK_FALSE(fit_fall(straight, false));
}
