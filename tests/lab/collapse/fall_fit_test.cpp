// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/fall_fit.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

using namespace triax::lab;

namespace {

constexpr double kEta = 0.6;     ///< η_c
constexpr double kQ = 60e3;      ///< q there
constexpr double kRate = 200;    ///< of q, a reading, over the stage
constexpr double kFall = 100.6;  ///< reading of it, under a load that grows steadily

/// dq/dε₁ = k (η_c − η) with η linear in ε₁ and q in time: η_c − η = √((q_c − q)/b).
std::vector<PathSample> under_load(double noise = 0, std::uint64_t seed = 3, double fall = kFall,
                                   double b = 2e6) {
  std::mt19937_64 rng(seed);
  std::normal_distribution<double> unit(0, 1);
  std::vector<PathSample> samples;
  for (int i = 76; i <= 100; ++i) {
    PathSample sample;
    auto& s = sample.signal;
    const double q = kQ - kRate * (fall - i), eta = kEta - std::sqrt((kQ - q) / b);
    s[PathSample::reading] = i;
    s[PathSample::progress] = 2.0 * i;
    s[PathSample::axial_strain] = 0.02 * eta;
    s[PathSample::q] = q + noise * unit(rng);
    s[PathSample::p_eff] = q / eta + noise * unit(rng);
    s[PathSample::volumetric_strain] = 0;
    s[PathSample::pore_pressure] = 300e3;
    samples.push_back(sample);
  }
  return samples;
}

/// A spring lets q pass its peak nine readings before the fall: η grows steadily.
std::vector<PathSample> past_peak(double noise = 0, std::uint64_t seed = 5) {
  auto samples = under_load();
  std::mt19937_64 rng(seed);
  std::normal_distribution<double> unit(0, 1);
  for (PathSample& sample : samples) {
    auto& s = sample.signal;
    const double eta = kEta + 0.004 * (s[PathSample::reading] - 91);
    s[PathSample::axial_strain] = 0.02 * eta;
    s[PathSample::q] = kQ - 2e6 * (eta - kEta) * (eta - kEta) + noise * unit(rng);
    s[PathSample::p_eff] = s[PathSample::q] / eta + noise * unit(rng);
  }
  return samples;
}

/// q is held, p′ falls, and the volume turns at reading 90.
std::vector<PathSample> at_held_q(double search) {
  auto samples = under_load();
  std::mt19937_64 rng(7);
  std::normal_distribution<double> unit(0, 1);
  for (PathSample& sample : samples) {
    auto& s = sample.signal;
    const double x = s[PathSample::reading] - 90;
    s[PathSample::q] = kQ + (std::fmod(x, 2) == 0 ? search : -search);
    s[PathSample::p_eff] = 100e3 - 200 * x;
    s[PathSample::volumetric_strain] = 1e-6 * x * x + 2e-6 * unit(rng);
  }
  return samples;
}

}  // namespace

TEST_CASE("fit_fall: with a compressible pore fluid work vanishes before the peak of q") {
  auto samples = under_load(0, 3, kFall, 2e5);
  for (PathSample& s : samples)
    s.signal[PathSample::pore_pressure] = 400e3 - s.signal[PathSample::p_eff];
  // dq/dε₁ = −c (du/dε₁)(dp′/dε₁) = c (dp′/dε₁)² with q = q_c − b (η_c − η)², p′ = q/η, ε₁ = 0.02
  // η.
  constexpr double kC = 2e-8, kB = 2e5, kStrain = 0.02;
  double low = 0.4, high = kEta;
  for (int i = 0; i < 50; ++i) {
    const double eta = (low + high) / 2, q = kQ - kB * (kEta - eta) * (kEta - eta);
    const double q_rate = 2 * kB * (kEta - eta) / kStrain;
    const double p_rate = (q_rate * kStrain / eta - q / (eta * eta)) / kStrain;
    (q_rate > kC * p_rate * p_rate ? low : high) = eta;
  }
  REQUIRE(kEta - low > 0.03);
  const auto rigid = fit_fall(samples, false, kRate);
  const auto fit =
      fit_fall(samples, false, kRate, FluidCompliance{.rigid = kC, .least = 0.6, .most = 1.5});
  REQUIRE(rigid);
  REQUIRE(fit);
  CHECK(fit->point.eta() == Approx(low).margin(0.01));
  CHECK(fit->point.reading < 100);
  CHECK(fit->interval.eta.holds(low));
  CHECK(fit->interval.eta.low < low - 0.3 * (kEta - low));
  CHECK(fit->interval.eta.high < kEta);
  CHECK(rigid->point.eta() == Approx(kEta).margin(5e-3));
}

TEST_CASE("fit_fall: in extension the modulus has its root as in compression") {
  auto samples = under_load();
  for (PathSample& s : samples)
    for (const auto signal : {PathSample::q, PathSample::axial_strain}) s.signal[signal] *= -1;
  const auto fit = fit_fall(samples, false, -kRate);
  REQUIRE(fit);
  CHECK(fit->point.eta() == Approx(-kEta).margin(2e-3));
  const auto compression = fit_fall(under_load(), false, kRate);
  CHECK(fit->interval.eta.high - fit->interval.eta.low ==
        Approx(compression->interval.eta.high - compression->interval.eta.low));
}

TEST_CASE("the limit point of a load is the root of the tangent modulus, beyond the last reading") {
  const auto fit = fit_fall(under_load(), false, kRate);
  REQUIRE(fit);
  // At the last reading η is 0.592; the parabola of twelve readings does not follow its rate.
  CHECK(fit->point.eta() == Approx(kEta).margin(2e-3));
  CHECK(fit->point.q == Approx(kQ).epsilon(3e-3));
  CHECK(fit->point.axial_strain == Approx(0.02 * kEta).epsilon(2e-3));
  CHECK(fit->point.reading == 100);
  CHECK(fit->point.progress > 200);
  CHECK(fit->interval.eta.holds(kEta));
  CHECK(fit->interval.eta.high - fit->interval.eta.low < 0.02);
}

TEST_CASE("coarse readings: the root lies where no reading came near, and the interval holds it") {
  // Every third reading up to 99, the fall shortly before the next: the last ratio is 0.547.
  std::vector<PathSample> coarse;
  for (const PathSample& s : under_load(0, 3, 101.8, 2e5))
    if (std::fmod(s.signal[PathSample::reading], 3) == 0) coarse.push_back(s);
  REQUIRE(coarse.size() == 8);
  for (PathSample& s : coarse) s.signal[PathSample::reading] /= 3;
  const auto fit = fit_fall(coarse, false, kRate);
  REQUIRE(fit);
  CHECK(fit->point.eta() == Approx(kEta).margin(5e-3));
  CHECK(fit->interval.eta.holds(kEta));
}

TEST_CASE("in noise the interval of the fall holds the truth") {
  int held = 0;
  constexpr int kTimes = 200;
  for (int seed = 1; seed <= kTimes; ++seed) {
    const auto fit = fit_fall(under_load(150, static_cast<std::uint64_t>(seed)), false, kRate);
    if (fit) held += fit->interval.eta.holds(kEta);
  }
  CHECK(held > 0.78 * kTimes);  // the last readings bend away from the parabola through twelve
}

TEST_CASE("under a load q at the fall lies between the last reading and what the next would be") {
  const auto samples = under_load();
  const auto fit = fit_fall(samples, false, kRate);
  REQUIRE(fit);
  const double last = samples.back().signal[PathSample::q];
  CHECK(fit->interval.q_pa.low <= Approx(last));
  CHECK(fit->interval.q_pa.high >= Approx(last + kRate));
  CHECK(fit->point.q < last + 1.05 * kRate);
  CHECK(fit->interval.q_pa.high < last + 1.2 * kRate);
}

TEST_CASE("a spring's peak that noise hides lies where the slope of q may be zero, not ahead") {
  int held = 0;
  double widest = 0;
  constexpr int kTimes = 200;
  for (int seed = 1; seed <= kTimes; ++seed) {
    const auto fit = fit_fall(past_peak(200, static_cast<std::uint64_t>(seed)), false, kRate);
    if (!fit) continue;
    held += fit->interval.eta.holds(kEta);
    widest = std::max(widest, fit->interval.eta.high - fit->interval.eta.low);
  }
  CHECK(held > 0.93 * kTimes);
  CHECK(widest < 0.02);
}

TEST_CASE("at held q the interval reaches back to where the volume turned, and over a search") {
  auto samples = at_held_q(0);
  const auto eta_at = [&](std::size_t i) {
    return samples[i].signal[PathSample::q] / samples[i].signal[PathSample::p_eff];
  };
  const auto quiet = fit_fall(samples, true, 0);
  REQUIRE(quiet);
  CHECK(quiet->interval.eta.low < eta_at(15));  // it turned ten readings before the last
  CHECK(quiet->interval.eta.low > eta_at(10));
  CHECK(quiet->interval.eta.high > eta_at(24) + (eta_at(24) - eta_at(23)));
  const auto searching = fit_fall(at_held_q(300), true, 0);
  REQUIRE(searching);
  CHECK(searching->interval.eta.low < eta_at(8));
}

TEST_CASE("a peak of q before the fall is the onset, unless q was held") {
  const auto fit = fit_fall(past_peak(), false, kRate);
  REQUIRE(fit);
  CHECK(fit->point.eta() == Approx(kEta).margin(1e-4));
  CHECK(fit->point.q == Approx(kQ).epsilon(5e-3));
  CHECK(fit->point.reading == Approx(91).margin(1));
  const auto noisy = fit_fall(past_peak(50), false, kRate);
  REQUIRE(noisy);
  CHECK(noisy->point.eta() == Approx(kEta).margin(0.005));
  CHECK(noisy->interval.eta.holds(kEta));
}

TEST_CASE("at held q the last reading counts") {
  const auto samples = under_load();
  const auto fit = fit_fall(samples, true, kRate);
  REQUIRE(fit);
  const auto& last = samples.back().signal;
  CHECK(fit->point.reading == 100);
  CHECK(fit->point.progress == Approx(200));
  CHECK(fit->point.q == Approx(last[PathSample::q]).epsilon(1e-3));
  CHECK(fit->point.eta() == Approx(last[PathSample::q] / last[PathSample::p_eff]).margin(2e-3));
  CHECK(fit->interval.eta.high > fit->point.eta());
}

TEST_CASE("too few readings, or a ratio that does not grow, tell nothing") {
  const auto samples = under_load();
  CHECK_FALSE(fit_fall(std::span(samples).last(7), false, kRate));
  auto back = samples;
  for (auto& s : back) s.signal[PathSample::p_eff] *= s.signal[PathSample::reading] - 70;
  CHECK_FALSE(fit_fall(back, false, kRate));
}
