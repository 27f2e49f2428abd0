// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/control_peak.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace triax::lab;

namespace {

PathPoint point_of_q(int reading, double q) {
  PathPoint p;
  p.reading = reading;
  p.progress = reading;
  p.window_readings = 14;
  p.q = q;
  p.p_eff = 100e3;
  return p;
}

}  // namespace

TEST_CASE("of several peaks of q the one that cost most is kept") {
  ControlPeak peak;
  peak.start_stage(nullptr);
  int reading = 0;
  for (const double q : {50e3, 100e3, 80e3}) peak.add_point(point_of_q(reading++, q), true);
  REQUIRE(peak.finding());
  CHECK(peak.finding()->instant.reading == 1);
  for (const double q : {120e3, 30e3}) peak.add_point(point_of_q(reading++, q), true);
  CHECK(peak.finding()->instant.reading == 3);
  for (const double q : {150e3, 130e3}) peak.add_point(point_of_q(reading++, q), true);
  CHECK(peak.finding()->instant.reading == 3);
}

TEST_CASE("a peak is known when a tenth of it is lost, however far q falls later") {
  ControlPeak peak;
  peak.start_stage(nullptr);
  int reading = 0;
  for (const double q : {50e3, 100e3, 95e3, 80e3, 40e3, 10e3}) {
    peak.set_now(Moment{reading + 5, {}});
    peak.add_point(point_of_q(reading++, q), true);
  }
  REQUIRE(peak.finding());
  REQUIRE(peak.finding()->noticed);
  CHECK(peak.finding()->noticed->reading == 8);  // the fourth point_of_q, five readings later
}

TEST_CASE("less than a tenth is no peak") {
  ControlPeak peak;
  peak.start_stage(nullptr);
  int reading = 0;
  for (const double q : {50e3, 100e3, 91e3, 95e3}) peak.add_point(point_of_q(reading++, q), true);
  CHECK_FALSE(peak.finding());
}

TEST_CASE("at constant q, drained, the turn to contraction under falling p' is found") {
  const StageInfo stage{
      .role = StageRole::shear, .drainage = Drainage::open, .control = AxialControl::constant_q};
  std::mt19937_64 rng(9);
  std::normal_distribution<double> noise(0, 1e-7);
  ControlPeak peak;
  peak.start_stage(&stage);
  for (int i = 0; i < 400; ++i) {
    PathPoint p = point_of_q(i, 60e3);
    p.p_rate = -50;
    p.p_rate_error = 2;
    p.axial_rate = 1e-6;
    p.volumetric_rate = (i - 200) * 5e-9 + noise(rng);  // swells before, contracts after
    p.volumetric_rate_error = 1e-7;
    peak.add_point(p, true);
  }
  REQUIRE(peak.finding());
  CHECK(std::abs(peak.finding()->instant.reading - 200) < 25);
}

TEST_CASE("contraction while p' does not fall is consolidation, no collapse") {
  const StageInfo stage{
      .role = StageRole::shear, .drainage = Drainage::open, .control = AxialControl::constant_q};
  ControlPeak peak;
  peak.start_stage(&stage);
  for (int i = 0; i < 100; ++i) {
    PathPoint p = point_of_q(i, 60e3);
    p.p_rate = 50;
    p.p_rate_error = 2;
    p.volumetric_rate = 1e-6;
    p.volumetric_rate_error = 1e-8;
    peak.add_point(p, true);
  }
  CHECK_FALSE(peak.finding());
}

TEST_CASE("at constant q with the valve closed the minimum of u under falling p' is found") {
  const StageInfo stage{
      .role = StageRole::shear, .drainage = Drainage::closed, .control = AxialControl::constant_q};
  std::mt19937_64 rng(11);
  std::normal_distribution<double> noise(0, 2);
  ControlPeak peak;
  peak.start_stage(&stage);
  for (int i = 0; i < 400; ++i) {
    PathPoint p = point_of_q(i, 60e3);
    p.p_rate = -20;
    p.p_rate_error = 1;
    p.pore_rate = (i - 200) * 0.1 + noise(rng);
    p.pore_rate_error = 2;
    peak.add_point(p, true);
  }
  REQUIRE(peak.finding());
  CHECK(std::abs(peak.finding()->instant.reading - 200) < 30);
}

TEST_CASE("noise around q = 0 is no peak") {
  ControlPeak peak;
  peak.start_stage(nullptr);
  std::mt19937_64 rng(10);
  std::normal_distribution<double> noise(0, 200);
  for (int i = 0; i < 500; ++i) {
    PathPoint p = point_of_q(i, 10.0 * i + noise(rng));
    p.stress_variance = 200.0 * 200.0;
    peak.add_point(p, true);
    REQUIRE_FALSE(peak.finding());
  }
}

namespace {

/// q rises with reading, p′ so that X = σ₁′ − σ₃′/R is a parabola with its top at reading 100:
/// X = p (1 − 1/R) + q (2/3 + 1/(3R)).
PathPoint on_path(int reading, double R) {
  const double x = 50e3 - 5 * (reading - 100) * (reading - 100);
  PathPoint p = point_of_q(reading, 40e3 + 100.0 * reading);
  p.p_eff = (x - p.q * (2.0 / 3 + 1 / (3 * R))) / (1 - 1 / R);
  return p;
}

}  // namespace

TEST_CASE("on a strain path the peak is that of σ₁' − σ₃'/R, while q still rises") {
  const StageInfo stage{.role = StageRole::shear,
                        .drainage = Drainage::open,
                        .control = AxialControl::displacement,
                        .strain_path_R = 1.5};
  ControlPeak with_R, with_q;
  with_R.start_stage(&stage);
  with_q.start_stage(nullptr);
  for (int i = 0; i < 200; ++i) {
    with_R.add_point(on_path(i, 1.5), true);
    with_q.add_point(on_path(i, 1.5), true);
  }
  REQUIRE(with_R.finding());
  CHECK(with_R.finding()->instant.reading == 100);
  CHECK(with_R.finding()->evidence.find("R = 1.5") != std::string::npos);
  CHECK_FALSE(with_q.finding());
}

TEST_CASE("with the valve closed, a pore pressure that only rises places the turn at the start") {
  const StageInfo stage{
      .role = StageRole::shear, .drainage = Drainage::closed, .control = AxialControl::constant_q};
  ControlPeak peak;
  peak.start_stage(&stage);
  for (int i = 0; i < 400; ++i) {
    PathPoint p = point_of_q(i, 60e3);
    p.p_rate = -50;
    p.p_rate_error = 1;
    p.pore_rate = 10 + 0.1 * i;
    p.pore_rate_error = 1;
    peak.add_point(p, true);
  }
  REQUIRE(peak.finding());
  CHECK(peak.finding()->instant.reading == 0);
}
