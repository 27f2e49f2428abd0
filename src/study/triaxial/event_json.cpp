// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/event_json.hpp"

#include <utility>

namespace triax::study {

Json moment_json(const std::optional<lab::Moment>& moment) {
  if (!moment) return nullptr;
  return {{"reading", moment->reading}, {"time_s", json_number(moment->time_s)}};
}

Json outlook_json(const std::optional<lab::Outlook>& outlook) {
  if (!outlook) return nullptr;
  Json left = nullptr;
  if (outlook->left)
    left = {{"quantity", lab::heading(outlook->left->quantity)},
            {"value", lab::in_field_units(*outlook->left)},
            {"time_s", json_number(outlook->left->time_s)}};
  return {{"reading", outlook->reading},   {"time_s", json_number(outlook->time_s)},
          {"eta_forecast", outlook->eta},  {"eta_low", outlook->eta_low},
          {"eta_high", outlook->eta_high}, {"left", std::move(left)}};
}

Json event_json(const lab::Event& event) {
  const auto& noticed = event.noticed;
  return {{"kind", to_string(event.kind)},
          {"reading", event.reading},
          {"time_s", json_number(event.time_s)},
          {"noticed_reading", noticed ? Json(noticed->reading) : Json(nullptr)},
          {"noticed_time_s", json_number(noticed ? noticed->time_s : std::nullopt)},
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
