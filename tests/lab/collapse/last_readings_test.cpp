// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/last_readings.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/devices/noise.hpp"

using namespace triax::lab;

namespace {

/// q over the readings 0 to count − 1.
std::vector<PathSample> samples_of(int count, const std::function<double(double)>& q) {
  std::vector<PathSample> samples(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    auto& s = samples[static_cast<std::size_t>(i)].signal;
    s[PathSample::reading] = i;
    s[PathSample::q] = q(i);
  }
  return samples;
}

double noise(double i) { return standard_normal(3, 1, static_cast<std::uint64_t>(i)); }

}  // namespace

TEST_CASE("of three terms without noise the coefficients come back, with no scatter") {
  std::vector<Eigen::Vector3d> terms;
  std::vector<double> y;
  for (int i = -5; i <= 0; ++i) {
    terms.emplace_back(1, i, i * i);
    y.push_back(7 - 2 * i + 0.5 * i * i);
  }
  const ThreeTerms fit(terms, y);
  CHECK(fit.c[0] == Approx(7));
  CHECK(fit.c[1] == Approx(-2));
  CHECK(fit.c[2] == Approx(0.5));
  CHECK(fit.scatter < 1e-9);
}

TEST_CASE("value, rate and bend at the last reading are those of the parabola, and reach ahead") {
  const auto samples = samples_of(40, [](double i) { return 100 + 3 * i - 0.02 * i * i; });
  const AtLast at = at_last(samples, PathSample::q, 12);
  CHECK(at.value == Approx(100 + 3 * 39 - 0.02 * 39 * 39));
  CHECK(at.rate == Approx(3 - 0.04 * 39));
  CHECK(at.bend == Approx(-0.02));
  CHECK(at.before(2) == Approx(100 + 3 * 41 - 0.02 * 41 * 41));
  CHECK(at.rate_at(-4) == Approx(3 - 0.04 * 35));
}

TEST_CASE("the error of a value is that of repeated noise") {
  double square = 0, claimed = 0;
  constexpr int kTrials = 400;
  for (int t = 0; t < kTrials; ++t) {
    const auto samples = samples_of(16, [&](double i) { return noise(i + 100 * t); });
    const AtLast at = at_last(samples, PathSample::q, 16);
    square += at.value * at.value / kTrials;
    claimed += at.value_error * at.value_error / kTrials;
  }
  CHECK(std::sqrt(claimed) == Approx(std::sqrt(square)).epsilon(0.1));
}

TEST_CASE("a parabola that turned may have turned there and not elsewhere; a line nowhere") {
  const auto turned =
      samples_of(60, [](double i) { return -(i - 54) * (i - 54) + 0.3 * noise(i); });
  const Turned t = may_have_turned(turned, PathSample::q);
  REQUIRE(t.anywhere());
  CHECK(t.first <= -5);  // the last reading is 59
  CHECK(t.last >= -5.25);
  CHECK(t.last - t.first < 3);
  const auto line = samples_of(60, [](double i) { return 5 * i + 0.3 * noise(i); });
  CHECK_FALSE(may_have_turned(line, PathSample::q).anywhere());
  CHECK_FALSE(may_have_turned(samples_of(5, [](double) { return 1; }), PathSample::q).anywhere());
}

TEST_CASE("q under a load grows on to the end; through a spring it slows down before its peak") {
  const auto load = samples_of(60, [](double i) { return 2 * i + 0.3 * noise(i); });
  CHECK(grows_steadily(load, 2));
  const auto spring =
      samples_of(60, [](double i) { return 240 - (60 - i) * (60 - i) / 15 + 0.3 * noise(i); });
  CHECK_FALSE(grows_steadily(spring, 4));
}

namespace {

/// At held q: p′ falls by 1 kPa a reading, u by `u`.
std::vector<PathSample> held_samples(int count, const std::function<double(double)>& u) {
  auto samples = samples_of(count, [](double) { return 60e3; });
  for (int i = 0; i < count; ++i) {
    auto& s = samples[static_cast<std::size_t>(i)].signal;
    s[PathSample::p_eff] = 200e3 - 1e3 * i;
    s[PathSample::pore_pressure] = u(i);
    s[PathSample::volumetric_strain] = -1e-8 * u(i);
  }
  return samples;
}

}  // namespace

TEST_CASE("contracts_at_end: three readings past the turn of u are enough") {
  const auto turn_at = [](double last) {
    return [last](double i) { return 300e3 + 40 * (i - last) * (i - last); };
  };
  CHECK(contracts_at_end(held_samples(30, turn_at(26)), false));
  CHECK_FALSE(contracts_at_end(held_samples(30, turn_at(30)), false));
  CHECK_FALSE(contracts_at_end(held_samples(30, turn_at(26)), true));  // the volume grows
  CHECK_FALSE(contracts_at_end(held_samples(5, turn_at(1)), false));
}

TEST_CASE("contracts_at_end: noise is no turn") {
  int found = 0;
  for (int trial = 0; trial < 200; ++trial)
    found += contracts_at_end(
        held_samples(64, [&](double i) { return 300e3 + 200 * noise(i + 1000 * trial); }), false);
  CHECK(found <= 4);
}

namespace {

/// Undrained, by displacement: q over the readings 0 to count − 1, with some noise.
std::vector<PathSample> frame_samples(int count, const std::function<double(double)>& q,
                                      const std::function<double(double)>& strain) {
  auto samples = samples_of(count, q);
  for (int i = 0; i < count; ++i) {
    auto& s = samples[static_cast<std::size_t>(i)].signal;
    s[PathSample::q] += 5 * noise(i);
    s[PathSample::axial_strain] = strain(i) + 1e-6 * noise(i + 1000);
    s[PathSample::p_eff] = 1e5 - 500 * i + 5 * noise(i + 2000);
    s[PathSample::volumetric_strain] = 1e-8 * noise(i + 3000);
  }
  return samples;
}

}  // namespace

TEST_CASE("softens_at_end: a peak of q a few readings before the end is enough") {
  const auto strain = [](double i) { return 1e-4 * i; };
  const auto peak_at = [](double top) {
    return [top](double i) { return 1e5 - 20 * (i - top) * (i - top); };
  };
  CHECK(softens_at_end(frame_samples(40, peak_at(34), strain), 1e-4));
  CHECK_FALSE(softens_at_end(frame_samples(40, peak_at(39), strain), 1e-4));  // it ends there
  CHECK_FALSE(softens_at_end(frame_samples(40, peak_at(60), strain), 1e-4));
  CHECK_FALSE(softens_at_end(frame_samples(5, peak_at(2), strain), 1e-4));
  // In extension q and the strain change their signs, and the work does not.
  const auto extended = [&](double i) { return -peak_at(34)(i); };
  CHECK(softens_at_end(frame_samples(40, extended, [](double i) { return -1e-4 * i; }), -1e-4));
}

TEST_CASE("softens_at_end: unloading and relaxation are no softening") {
  const auto falls = [](double i) { return i < 34 ? 1e5 : 1e5 - 3000 * (i - 34); };
  const auto back = [](double i) { return i < 34 ? 1e-4 * i : 1e-4 * (68 - i); };
  const auto rests = [](double i) { return 1e-4 * std::min(i, 34 + 0.05 * (i - 34)); };
  CHECK_FALSE(softens_at_end(frame_samples(40, falls, back), 1e-4));
  CHECK_FALSE(softens_at_end(frame_samples(40, falls, rests), 1e-4));
}
