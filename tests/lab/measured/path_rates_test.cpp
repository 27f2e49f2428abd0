// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/path_rates.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/measured/synthetic_path.hpp"

using namespace triax::lab;
using triax::lab::testing::SyntheticPath;

namespace {

std::vector<PathPoint> points_of(SyntheticPath path, int readings) {
  std::vector<PathPoint> points;
  PathRates rates;
  rates.on_point = [&](const PathPoint& p) { points.push_back(p); };
  for (int i = 0; i < readings; ++i) {
    const State s = path.state(i);
    PathSample sample;
    sample.signal = {double(i), s.time_s, s.q, s.p_eff, s.strain.axial, 0, s.pore_pressure};
    rates.add(sample);
  }
  rates.finish();
  return points;
}

}  // namespace

TEST_CASE("rates of a smooth path are its derivatives") {
  const SyntheticPath path;
  for (const PathPoint& p : points_of(path, 3000)) {
    if (p.reading < 10 || std::fabs(p.axial_strain - path.peak_strain) < 2e-5) continue;
    const double h = 1e-6;
    const double slope = (path.q(p.axial_strain + h) - path.q(p.axial_strain - h)) / (2 * h);
    CHECK(p.q_rate == Approx(slope * path.strain_step).epsilon(0.01).margin(0.05));
    CHECK(p.axial_rate == Approx(path.strain_step).epsilon(1e-6));
  }
}

TEST_CASE("the window follows the noise, and the work is resolved all the same") {
  const auto quiet = points_of({}, 6000);
  SyntheticPath loud;
  loud.q_noise = loud.u_noise = 300;
  const auto noisy = points_of(loud, 6000);
  const auto near = [](const std::vector<PathPoint>& points, double reading) {
    return *std::min_element(points.begin(), points.end(), [&](auto& a, auto& b) {
      return std::fabs(a.reading - reading) < std::fabs(b.reading - reading);
    });
  };
  CHECK(near(quiet, 300).window_readings == 7);
  CHECK(near(noisy, 300).window_readings > 7);
  for (const double reading : {200.0, 1200.0, 2000.0}) {
    const auto a = near(quiet, reading), b = near(noisy, reading);
    CHECK(b.work.normalised == Approx(a.work.normalised).margin(4 * b.normalised_error));
    CHECK(b.normalised_error < 0.1);
  }
}

TEST_CASE("the stated error covers the true one") {
  SyntheticPath path;
  path.q_noise = path.u_noise = 200;
  const auto truth = points_of({}, 4000);
  int within = 0, all = 0;
  for (const PathPoint& p : points_of(path, 4000)) {
    const auto& t =
        truth[std::min<std::size_t>(std::size_t(std::max(0.0, p.reading - 3)), truth.size() - 1)];
    if (p.normalised_error > 0.5) continue;
    ++all;
    within += std::fabs(p.work.normalised - t.work.normalised) < 3 * p.normalised_error;
  }
  REQUIRE(all > 20);
  CHECK(double(within) / all > 0.97);
}

TEST_CASE("a direction is no better known than its vector") {
  CHECK(direction_error({.q = 0, .p = 1e3, .axial = 1e-4, .volumetric = 0}, 0, 0) == 0);
  CHECK(direction_error({.q = 0, .p = 0, .axial = 1e-4, .volumetric = 0}, 1, 0) == 2);
  const PathStep step{.q = 300, .p = -100, .axial = 1e-4, .volumetric = 2e-5};
  CHECK(direction_error(step, 1, 0) == Approx(1 / std::sqrt(3 * 1e4 + 6e4)));
  CHECK(normalised_second_order_work({.q = -1, .p = 0, .axial = 1, .volumetric = 0}) < 0);
}
