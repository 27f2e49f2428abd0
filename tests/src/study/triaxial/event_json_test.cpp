// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/event_json.hpp"

#include <catch2/catch.hpp>

using namespace triax;

TEST_CASE("forecast_json: a cyclic warning has a probability and no η", "[study][cyclic]") {
  lab::Forecast forecast{.reading = 7, .time_s = 3.5};
  forecast.eta = forecast.eta_low = forecast.eta_high = lab::kMissing;
  forecast.cyclic = lab::CyclicForecast{0.75, 4.5};
  const study::Json json = study::forecast_json(forecast);
  CHECK(json["failure_probability"] == 0.75);
  CHECK(json["load_cycles"] == 4.5);
  CHECK(json["eta_forecast"].is_null());
  CHECK(json["reading"] == 7);
}

TEST_CASE("forecast_json: a forecast of η has no probability", "[study]") {
  const study::Json json = study::forecast_json(
      lab::Forecast{.reading = 7, .eta = 0.6, .eta_low = 0.5, .eta_high = 0.7});
  CHECK(json["eta_forecast"] == 0.6);
  CHECK(json["failure_probability"].is_null());
  CHECK(study::forecast_json(std::nullopt).is_null());
}
