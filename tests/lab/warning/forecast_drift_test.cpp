// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/forecast_drift.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

/// Forecasts that rise from 0.5 by `slope` a unit of η, from η = 0.2 to 0.4.
ForecastDrift::Slope slope_of(double slope, double error) {
  ForecastDrift drift;
  for (int i = 0; i <= 20; ++i) {
    const double now = 0.2 + 0.01 * i;
    drift.add(now, 0.5 + slope * (now - 0.2) - now, error);
  }
  return drift.slope();
}

}  // namespace

TEST_CASE("forecasts that move show by how much, as far as their fits are sure") {
  CHECK(slope_of(0.4, 1e-5).value == Approx(0.4).epsilon(1e-3));
  CHECK(slope_of(-0.4, 1e-5).value == Approx(-0.4).epsilon(1e-3));
  CHECK(slope_of(0.4, 1e-5).error < 1e-3);
  // An error as large as what is seen of them moves nothing, and then nothing is known.
  CHECK(slope_of(0.4, 1).value < 0.01);
  CHECK(slope_of(0.4, 1).error == Approx(0.7).epsilon(0.01));
}

TEST_CASE("one forecast tells of no drift, and what was long ago is forgotten") {
  ForecastDrift drift;
  drift.add(0.2, 0.1, 0.01);
  CHECK(drift.slope().value == 0);
  CHECK(drift.slope().error == Approx(0.7));
  for (int i = 1; i <= 20; ++i) drift.add(0.2 + 0.005 * i, 0.1, 1e-6);  // moves with η
  CHECK(drift.slope().value == Approx(1).epsilon(0.05));
  for (int i = 1; i <= 100; ++i) drift.add(0.3 + 9e-4 * i, 0.1 - 9e-4 * i, 1e-6);
  CHECK(drift.slope().value < 0.1);  // stands at 0.4
}
