// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What was said while a test ran, as parts of JSON documents.
#include <optional>

#include "lab/results/record_header.hpp"
#include "lab/results/summary.hpp"
#include "src/study/json_parts.hpp"

namespace triax::study {

/// Null where it is unknown.
Json moment_json(const std::optional<lab::Moment>& moment);
/// η at the onset with its 90 % interval and what is left until then, or the probability of failure
/// within one load cycle. Null without a forecast.
Json forecast_json(const std::optional<lab::Forecast>& forecast);
/// Of which reading it speaks, and at which it was known.
Json event_json(const lab::Event& event);
Json stage_json(const lab::StageInfo& stage);

}  // namespace triax::study
