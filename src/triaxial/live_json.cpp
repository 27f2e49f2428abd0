// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/live_json.hpp"

#include "src/study/triaxial/event_json.hpp"
#include "src/study/triaxial/test_result.hpp"
#include "src/triaxial/json_report.hpp"

namespace triax::src {
namespace {

using study::Json;

Json row_json(const study::LiveRow& row) {
  const auto& said = row.said;
  return {{"reading", said ? Json(said->reading) : Json(nullptr)},
          {"time_s", study::json_number(said ? said->time_s : std::nullopt)},
          {"stage", row.stage ? Json(*row.stage) : Json(nullptr)},
          {"eta", study::json_number(row.eta)},
          {"event", row.event ? study::event_json(*row.event) : Json(nullptr)},
          {"forecast", study::forecast_json(row.forecast)}};
}

Json lead_json(const std::optional<study::LiveLead>& lead) {
  if (!lead) return nullptr;
  return {{"readings", lead->readings}, {"time_s", study::json_number(lead->time_s)}};
}

Json account_json(const study::LiveAccount& account) {
  Json rows = Json::array();
  for (const auto& row : account.rows) rows.push_back(row_json(row));
  return {{"rows", std::move(rows)},
          {"forecasts", account.forecasts},
          {"forecasts_shown", account.shown},
          {"before_onset",
           {{"approaching", lead_json(account.approaching)},
            {"imminent", lead_json(account.imminent)}}}};
}

}  // namespace

Json live_json(const db::Store& store, std::int64_t id) {
  const auto test = study::load_test_result(store, id, study::WithCurves::no);
  Json document = Json::parse(json_of_test(test));
  document["live"] = account_json(study::live_account(store, test.stored));
  return document;
}

}  // namespace triax::src
