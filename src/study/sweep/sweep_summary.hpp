// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "src/study/sweep/spread.hpp"
#include "src/study/sweep/sweep_run.hpp"

namespace triax::study {

/// A collapse was found by the criteria.
bool collapse_detected(const SweepMember& member);

/// What a sweep came to over all its tests.
struct SweepSummary {
  std::int64_t tests = 0;
  std::int64_t stored = 0;   ///< are in the database
  std::int64_t failed = 0;   ///< said why
  std::int64_t not_run = 0;  ///< neither stored nor failed: the sweep was stopped
  std::int64_t judged = 0;
  std::int64_t detected = 0;             ///< collapses found
  std::int64_t truly_lost = 0;           ///< specimens that lost sustainability themselves
  std::int64_t truly_lost_detected = 0;  ///< of them, those where a collapse was found
  std::int64_t false_alarms = 0;         ///< a collapse was found in a specimen that stayed stable
  std::optional<Spread> eta;             ///< at the onset found
  std::optional<Spread> true_eta;        ///< where the specimen itself lost sustainability
  std::optional<Spread> eta_error;       ///< found less true, where both are known
};

SweepSummary summary_of(const std::vector<SweepMember>& members);

}  // namespace triax::study
