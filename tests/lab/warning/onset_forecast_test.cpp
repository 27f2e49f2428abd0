// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/onset_forecast.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/measured/path_sampler.hpp"
#include "tests/lab/warning/loose_path.hpp"

using namespace triax::lab;
using triax::lab::testing::LoosePath;
using triax::lab::testing::shear_header;

namespace {

/// Forecasts along a path from η = 0 to `last`, in that many readings.
std::optional<EtaForecast> forecast_at(LoosePath path, double last, int readings,
                                       OnsetForecast::Witness witness) {
  OnsetForecast forecast;
  forecast.start_stage(witness);
  PathSampler sampler(true);
  PathRates rates;
  rates.on_point = [&](const PathPoint& point) { forecast.add(point); };
  for (int i = 1; i <= readings; ++i) rates.add(*sampler.sample(path.at(last * i / readings, i)));
  return forecast.now();
}

}  // namespace

TEST_CASE("a stiffness that falls linearly over η is continued to its zero") {
  const double share = GENERATE(0.3, 0.5, 0.8, 0.95);
  const double onset = GENERATE(0.5, 0.75);
  LoosePath path{.eta_onset = onset};
  const auto f = forecast_at(path, share * onset, 400, OnsetForecast::Witness::stiffness);
  REQUIRE(f);
  INFO("after " << share << " of the way to " << onset);
  CHECK(f->eta == Approx(onset).epsilon(2e-3));
  CHECK(f->now == Approx(share * onset).epsilon(0.02));
  CHECK(f->left() == Approx(1 - f->now / f->eta).margin(1e-12));
}

TEST_CASE("it does not depend on the number of readings, long tests are held in as little") {
  const int readings = GENERATE(40, 400, 40000);
  const auto f = forecast_at({}, 0.5, readings, OnsetForecast::Witness::stiffness);
  REQUIRE(f);
  CHECK(f->eta == Approx(0.6).epsilon(5e-3));
}

TEST_CASE("noise widens the forecast, and two standard errors hold the onset") {
  int held = 0;
  double clean = 0, noisy = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    LoosePath path{.noise_pa = 200, .noise_strain = 2e-6};
    path.random.seed(seed);
    const auto f = forecast_at(path, 0.45, 300, OnsetForecast::Witness::stiffness);
    REQUIRE(f);
    held += std::fabs(f->eta - 0.6) < 2 * f->error;
    noisy += f->error / 40;
    clean = forecast_at({}, 0.45, 300, OnsetForecast::Witness::stiffness)->error;
  }
  CHECK(held >= 36);
  CHECK(noisy > clean);
}

TEST_CASE("what was to vanish for certain and did not is foretold no more") {
  // The stiffness falls as if to η = 0.6, but stays at a fiftieth from 0.57 on.
  OnsetForecast forecast;
  forecast.start_stage(OnsetForecast::Witness::stiffness);
  double q = 0, axial = 0;
  for (int i = 1; i <= 1500; ++i) {
    const double eta = 0.9 * i / 1500;
    PathPoint p;
    p.reading = p.progress = i;
    p.window_readings = 7;
    const double stiffness = std::max(1 - eta / 0.6, 0.05) * 2e7;
    p.axial_rate = 0.006 * 0.9 / 1500;
    p.q_rate = stiffness * p.axial_rate;
    q += p.q_rate, axial += p.axial_rate;
    p.q = q;
    p.p_eff = q / eta;
    p.p_rate = -50;
    p.axial_strain = axial;
    const double stress = std::sqrt(3 * p.p_rate * p.p_rate + p.q_rate * p.q_rate * 2 / 3);
    p.work.normalised = p.q_rate * p.axial_rate / (stress * std::sqrt(1.5) * p.axial_rate);
    p.normalised_error = 0.01;
    forecast.add(p);
    if (i == 850) {
      REQUIRE(forecast.now());
      CHECK(forecast.now()->eta == Approx(0.6).epsilon(0.02));
    }
  }
  CHECK_FALSE(forecast.now());
}

TEST_CASE("what drives a stage says what is looked at") {
  using W = OnsetForecast::Witness;
  const auto witness = [](AxialControl control, Drainage drainage) {
    return OnsetForecast::witness_of(&shear_header(control, drainage).stages.front());
  };
  CHECK(witness(AxialControl::load, Drainage::closed) == W::stiffness);
  CHECK(witness(AxialControl::displacement, Drainage::closed) == W::stiffness);
  CHECK(witness(AxialControl::displacement, Drainage::open) == W::none);
  CHECK(witness(AxialControl::constant_q, Drainage::open) == W::mixture);
  CHECK(witness(AxialControl::constant_q, Drainage::closed) == W::pore_pressure);
  RecordHeader path = shear_header(AxialControl::displacement, Drainage::open);
  path.stages.front().strain_path_R = 0.7;
  CHECK(OnsetForecast::witness_of(&path.stages.front()) == W::stiffness);
}
