// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/event_json.hpp"

#include <utility>

namespace triax::study {

Json moment_json(const std::optional<lab::Moment>& moment) {
  if (!moment) return nullptr;
  return {{"reading", moment->reading}, {"time_s", json_number(moment->time_s)}};
}

Json forecast_json(const std::optional<lab::Forecast>& forecast) {
  if (!forecast) return nullptr;
  Json left = nullptr;
  if (forecast->left)
    left = {{"quantity", lab::heading(forecast->left->quantity)},
            {"value", lab::in_field_units(*forecast->left)},
            {"time_s", json_number(forecast->left->time_s)}};
  const auto& cyclic = forecast->cyclic;
  return {{"reading", forecast->reading},
          {"time_s", json_number(forecast->time_s)},
          {"eta_forecast", json_number(forecast->eta)},
          {"eta_low", json_number(forecast->eta_low)},
          {"eta_high", json_number(forecast->eta_high)},
          {"left", std::move(left)},
          {"failure_probability", cyclic ? Json(cyclic->probability) : Json(nullptr)},
          {"load_cycles", cyclic ? Json(cyclic->load_cycles) : Json(nullptr)}};
}

Json event_json(const lab::Event& event) {
  const auto& detected_at = event.detected_at;
  return {{"kind", to_string(event.kind)},
          {"reading", event.reading},
          {"time_s", json_number(event.time_s)},
          {"detected_at_reading", detected_at ? Json(detected_at->reading) : Json(nullptr)},
          {"detected_at_time_s", json_number(detected_at ? detected_at->time_s : std::nullopt)},
          {"detail", event.detail}};
}

Json stage_json(const lab::StageInfo& stage) {
  return {{"number", stage.number},
          {"name", json_text(stage.name)},
          {"role", to_string(stage.role)},
          {"drainage", to_string(stage.drainage)},
          {"control", to_string(stage.control)}};
}

}  // namespace triax::study
