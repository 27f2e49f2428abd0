// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/onset_forecast.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <tuple>
#include <utility>

#include "tests/lab/warning/loose_path.hpp"

using namespace triax::lab;
using triax::lab::testing::LoosePath;
using triax::lab::testing::shear_header;

namespace {

OnsetForecast forecast_started(AxialControl by, Drainage drainage = Drainage::closed) {
  OnsetForecast forecast;
  const RecordHeader header = shear_header(by, drainage);
  forecast.start_stage(header.stage(1), true);
  return forecast;
}

/// At held q while p′ falls from p₀: dε_v/dp′ falls linearly over η from η₀ to η*, as
/// (1 − (η − η₀)/(η* − η₀))/K, and the shear strain grows as normalised work over p′ asks where
/// `straight`.
State held(double p, double q, double eta_onset, int reading) {
  constexpr double kP0 = 3e5, kBulk = 3e7;
  const double eta0 = q / kP0, reach = eta_onset - eta0;
  // ∫ (1 − (q/p − η₀)/reach) dp from p₀
  const double volume = ((1 + eta0 / reach) * (p - kP0) - q / reach * std::log(p / kP0)) / kBulk;
  State s;
  s.reading = reading;
  s.time_s = reading;
  s.p_eff = p;
  s.q = q;
  s.volumetric_strain = volume;
  s.strain = {2 * (kP0 - p) / kBulk, 0};
  s.pore_pressure = 5e5 - p;
  return s;
}

}  // namespace

TEST_CASE("a stiffness that falls linearly over η is continued to its zero, from few readings on") {
  // Among few readings the mean of the latest three lies behind, where the witnesses differ.
  for (const auto& [readings, margin] :
       {std::pair{9, 0.025}, {30, 0.01}, {400, 0.003}, {30000, 0.003}}) {
    OnsetForecast forecast = forecast_started(AxialControl::load);
    LoosePath path;
    for (int i = 1; i <= readings; ++i)
      forecast.add(path.at(path.eta_under_load(0.99 * i / readings), i));
    REQUIRE(forecast.now());
    CHECK(forecast.now()->eta == Approx(0.6).margin(margin));
    CHECK(forecast.now()->fall > 0.9);
  }
}

TEST_CASE("two witnesses that differ are met halfway, and what lies between is in the error") {
  // −dq/dp′ = 2(η* − η) of the path: its tangent times √η comes to zero later than the stiffness.
  OnsetForecast forecast = forecast_started(AxialControl::load);
  LoosePath path;
  for (int i = 1; i <= 400; ++i) forecast.add(path.at(0.001 * i, i));
  REQUIRE(forecast.now());
  const auto& f = *forecast.now();
  const double later = f.now + 1 / (1 / (0.6 - f.now) - 0.5 / f.now);
  CHECK(f.eta == Approx(0.5 * (0.6 + later)).margin(0.002));
  // The mean of the two moves as the second does, by 0.15 of η.
  // ln(distance/forecast) has a standard deviation of 0.7.
  const double between = 0.5 * (later - 0.6), factor = std::exp(1.645 * 0.7);
  const double below = (f.eta - f.now) * (1 - 1 / factor), above = (f.eta - f.now) * (factor - 1);
  CHECK(f.error == Approx(std::hypot(between, below / 1.645)).epsilon(0.02));
  CHECK(f.error_above == Approx(std::hypot(between, above / 1.645)).epsilon(0.02));
}

namespace {

/// At held q with the valve closed, du/dp′ = 1 − (η − 0.3)/0.3: u turns at η = 0.6.
OnsetForecast turning(int readings) {
  OnsetForecast forecast = forecast_started(AxialControl::constant_q, Drainage::closed);
  for (int i = 0; i <= readings; ++i) {
    const double p = 3e5 - 600.0 * i, q = 9e4;
    State s = held(p, q, 0.6, i + 1);
    s.pore_pressure = 5e5 + 2 * (p - 3e5) - q / 0.3 * std::log(p / 3e5);
    forecast.add(s);
  }
  return forecast;
}

}  // namespace

TEST_CASE("OnsetForecast: a root behind leaves the present state in the interval") {
  const OnsetForecast past = turning(270);  // η now 0.65
  REQUIRE(past.now());
  CHECK(past.now()->eta < past.now()->now - 0.03);
  CHECK(past.now()->eta + 1.645 * past.now()->error_above >= past.now()->now - 1e-6);
  CHECK(past.now()->eta - 1.645 * past.now()->error < past.now()->eta - 0.03);
  CHECK_FALSE(turning(290).now());            // η now 0.71: too far behind
  const OnsetForecast before = turning(245);  // η now 0.59: what is close is known well
  REQUIRE(before.now());
  CHECK(before.now()->eta > before.now()->now);
  CHECK(before.now()->error_above < 0.05);
}

TEST_CASE("OnsetForecast: near the onset every reading is evaluated, far from it few are") {
  // A long stage is evaluated with every 1/1024 of its readings there.
  const auto [readings, at_end, every] =
      GENERATE(std::tuple(2000, 40, 1), std::tuple(20000, 400, 19));
  OnsetForecast forecast = forecast_started(AxialControl::load);
  LoosePath path;
  int far = 0, near = 0;
  for (int i = 1; i <= readings; ++i) {
    const bool is_new = forecast.add(path.at(path.eta_under_load(0.999 * i / readings), i));
    if (i > readings / 4 && i <= readings / 2) far += is_new;
    if (i <= readings - at_end || !is_new) continue;
    ++near;
    CHECK(forecast.new_evidence() == Approx(std::min(every / 8.0, 1.0)));  // means of sixteen
  }
  CHECK(far < 100);
  CHECK(near >= at_end / every);
  CHECK(near <= at_end / every + 1);
}

TEST_CASE("normalised second-order work along the path is that of the closed form") {
  // R = 1, dε_v = 0: dq dε₁/(|dσ′||dε|) = r/√(4.5 + r²), r = −dq/dp′ = 2(η* − η)
  OnsetForecast forecast = forecast_started(AxialControl::load);
  LoosePath path;
  for (int i = 1; i <= 500; ++i) forecast.add(path.at(0.001 * i, i));
  REQUIRE(forecast.now());
  const double r = 2 * (0.6 - forecast.now()->now);
  CHECK(forecast.now()->work == Approx(r / std::sqrt(4.5 + r * r)).epsilon(0.01));
  CHECK(forecast.now()->work_error < 1e-3);
  CHECK(forecast.now()->covered == Approx(0.98).margin(0.02));
}

TEST_CASE("where few readings show that y came down, the onset was at the largest of them") {
  OnsetForecast forecast = forecast_started(AxialControl::displacement);
  LoosePath path;
  const double etas[] = {0.15, 0.3, 0.45, 0.58, 0.69, 0.78, 0.86, 0.93, 0.99, 1.04};
  int reading = 0;
  for (const double eta : etas) forecast.add(path.at(eta, ++reading));
  REQUIRE(forecast.now());
  CHECK(std::fabs(forecast.now()->eta - 0.6) <= 1.645 * forecast.now()->error);
  CHECK(forecast.now()->work < 0);
  // While y grows the largest is the latest, and nothing has come down.
  OnsetForecast growing = forecast_started(AxialControl::displacement);
  for (int i = 1; i <= 9; ++i) growing.add(path.at(0.03 * i, i));
  if (growing.now()) CHECK(growing.now()->eta > 0.5);
  // A load cell at the end of its range stands still: y does not come down.
  OnsetForecast saturated = forecast_started(AxialControl::displacement);
  for (int i = 1; i <= 12; ++i) {
    State s = path.at(0.05, i);
    s.strain.axial = 0.001 * i;
    s.p_eff = 1e5 - 20.0 * i;
    s.q = std::min(1e5, 2e4 * i);
    saturated.add(s);
  }
  if (saturated.now()) CHECK(saturated.now()->work > 0);
}

TEST_CASE("under noise the forecast holds the truth within its error") {
  int covered = 0;
  constexpr int kTrials = 60;
  for (unsigned seed = 1; seed <= kTrials; ++seed) {
    OnsetForecast forecast = forecast_started(AxialControl::load);
    LoosePath path{.noise_pa = 100, .noise_strain = 5e-6, .random = std::mt19937(seed)};
    for (int i = 1; i <= 300; ++i) forecast.add(path.at(path.eta_under_load(0.9 * i / 300), i));
    REQUIRE(forecast.now());
    covered += std::fabs(forecast.now()->eta - 0.6) <= 1.645 * forecast.now()->error;
  }
  CHECK(covered >= kTrials * 8 / 10);
}

TEST_CASE("what is left under a load is what the closed form leaves") {
  OnsetForecast forecast = forecast_started(AxialControl::load);
  LoosePath path;
  for (int i = 1; i <= 19800; ++i) forecast.add(path.at(path.eta_under_load(i / 20000.0), i));
  const auto& f = forecast.now();
  REQUIRE(f);
  const double q_left = 1e5 * (0.6 - f->now) * (0.6 - f->now) / 1.2;  // q = p₀ η (1 − η/1.2)
  CHECK(f->way_to(0.6) == Approx(q_left).epsilon(0.1));
  REQUIRE(forecast.rate());
  CHECK(*forecast.rate() == Approx(1e5 * 0.3 / 20000).epsilon(0.01));  // Pa/s
}

TEST_CASE("what is left by displacement is what the closed form leaves") {
  OnsetForecast forecast = forecast_started(AxialControl::displacement);
  LoosePath path;
  for (int i = 1; i <= 5500; ++i) forecast.add(path.at(0.0001 * i, i));
  const auto& f = forecast.now();
  REQUIRE(f);
  const double left = path.at(0.6, 0).strain.axial - path.at(0.55, 0).strain.axial;
  CHECK(f->way_to(f->eta) == Approx(left).epsilon(0.1));
}

TEST_CASE("where p' falls ever less there is no onset ahead, however soft the sand has become") {
  // p′ turns at η = 0.7 while dq/dε₁ is on its way to zero at about 0.9: phase transformation.
  OnsetForecast forecast = forecast_started(AxialControl::load);
  for (int i = 1; i <= 300; ++i) {
    State s = LoosePath{}.at(0.1, i);
    const double eta = 0.002 * i;
    s.p_eff = 1e5 * (1 - 0.5 * eta + 0.36 * eta * eta);
    s.q = eta * s.p_eff;
    s.strain.axial = 0.006 * eta / (1 - 0.3 * eta);
    forecast.add(s);
  }
  if (forecast.now()) CHECK(forecast.now()->fall < 0.7);
}

TEST_CASE("at held q, the valve closed, the pore pressure's turn is foretold") {
  OnsetForecast forecast = forecast_started(AxialControl::constant_q, Drainage::closed);
  // u falls as p′ does, du/dp′ = 1 − (η − 0.3)/0.3, and turns at η = 0.6.
  for (int i = 0; i <= 200; ++i) {
    const double p = 3e5 - 600.0 * i, q = 9e4;
    State s = held(p, q, 0.6, i + 1);
    s.pore_pressure = 5e5 + 2 * (p - 3e5) - q / 0.3 * std::log(p / 3e5);
    forecast.add(s);
  }
  REQUIRE(forecast.now());
  CHECK(forecast.now()->eta == Approx(0.6).margin(0.005));
}

TEST_CASE("at held q, the drainage open, the end of dilatation is foretold from normalised work") {
  OnsetForecast forecast = forecast_started(AxialControl::constant_q, Drainage::open);
  for (int i = 0; i <= 215; ++i) forecast.add(held(3e5 - 600.0 * i, 9e4, 0.6, i + 1));
  REQUIRE(forecast.now());
  CHECK(forecast.now()->now == Approx(0.53).margin(0.01));
  CHECK(forecast.now()->eta == Approx(0.6).margin(0.03));
  // w of dε_v = f dp′ and dε₁ = −2/K dp′
  CHECK(forecast.now()->work > 0);
  CHECK(forecast.now()->work < 0.2);
}

TEST_CASE("drained shear by displacement has no forecast, nor has too little of a stage") {
  LoosePath path;
  OnsetForecast drained = forecast_started(AxialControl::displacement, Drainage::open);
  for (int i = 1; i <= 500; ++i) drained.add(path.at(0.001 * i, i));
  CHECK_FALSE(drained.now());
  OnsetForecast few = forecast_started(AxialControl::load);
  for (int i = 1; i <= 7; ++i) few.add(path.at(0.07 * i, i));
  CHECK_FALSE(few.now());
}

TEST_CASE("a long window that bends over what came since says of no specimen that it is spent") {
  // dq/dε₁ = 1 + 90 (1 − η/0.8)² MPa up to η = 0.8, then 1 MPa: it levels out, and nothing
  // vanishes.
  const auto p_at = [](double eta) { return 1e5 - 4e4 * std::min(eta, 1.0); };
  OnsetForecast forecast = forecast_started(AxialControl::load);
  State s;
  double eta = 0.02, axial = 0;
  for (int i = 0; eta < 1.2; ++i) {
    s.reading = i;
    s.time_s = i;
    s.p_eff = p_at(eta);
    s.q = eta * s.p_eff;
    s.strain = {axial, -axial / 2};
    s.volumetric_strain = 0;
    forecast.add(s);
    if (eta > 0.5 && forecast.now()) CHECK(forecast.now()->work > 0);
    eta += 0.001;
    const double left = std::max(0.0, 1 - eta / 0.8);
    axial += (eta * p_at(eta) - s.q) / (1e6 + 90e6 * left * left);
  }
}

namespace {

EarlierTests told(double eta) {
  EarlierTests earlier;
  for (int i = 0; i < 2; ++i)
    earlier.add({.name = "earlier",
                 .control = DrivenPath::Control::strain_path,
                 .onset = eta,
                 .onset_error = 0.002});
  return earlier;
}

OnsetForecast told_of(double eta) {
  OnsetForecast forecast(told(eta));
  const RecordHeader header = shear_header(AxialControl::load);
  forecast.start_stage(header.stage(1), true);
  return forecast;
}

}  // namespace

TEST_CASE("earlier tests of the sand draw the forecast to theirs, and it is surer") {
  OnsetForecast alone = forecast_started(AxialControl::load), knowing = told_of(0.55);
  LoosePath path;
  for (int i = 1; i <= 300; ++i) {
    const State s = path.at(0.001 * i, i);
    alone.add(s);
    knowing.add(s);
  }
  REQUIRE(alone.now());
  REQUIRE(knowing.now());
  CHECK(knowing.now()->by_earlier);
  CHECK(knowing.now()->eta < alone.now()->eta - 0.02);
  CHECK(knowing.now()->eta > 0.55);
  // They differ: the error is not that of two that agree.
  CHECK(knowing.now()->error < alone.now()->error);
  OnsetForecast agreeing = told_of(alone.now()->eta);
  for (int i = 1; i <= 300; ++i) agreeing.add(path.at(0.001 * i, i));
  CHECK(agreeing.now()->error <= knowing.now()->error);
}

TEST_CASE("with them there is a forecast from the first reading, and none past what they say") {
  OnsetForecast knowing = told_of(0.6);
  LoosePath path;
  knowing.add(path.at(0.1, 1));
  REQUIRE(knowing.now());
  CHECK(knowing.now()->eta == Approx(0.6));
  // A specimen that went well past it does not lose it there.
  OnsetForecast wrong = told_of(0.3);
  for (int i = 1; i <= 500; ++i) wrong.add(path.at(0.001 * i, i));
  REQUIRE(wrong.now());
  CHECK_FALSE(wrong.now()->by_earlier);
  CHECK(wrong.now()->eta > 0.57);
}
