// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/study/json_parts.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::src {

/// The JSON contract (docs/contributing/architecture.md): one object for one test, an array for
/// several or none. Units are in the names (kPa, mm, degrees). An unknown value is null, never
/// absent, never 0. A test without an assessment (running, interrupted) has null for "detected" and
/// "kind".
std::string json_report(const std::vector<study::TestResult>& tests);

/// The object of one test alone, without a line end: for documents too long to be held whole.
std::string json_of_test(const study::TestResult& test);

/// The same as a value, to which others add.
study::Json test_document(const db::StoredTest& test);

/// {"onset": ..., "loss_of_control": ...}: the two instants of a test, null without one. Values as
/// in collapse, with the interval and detected_at; the onset of instability also has total_interval
/// and uncertainty_budget.
std::string json_of_instants(const db::StoredTest& test);

/// Of one test the parts test, specimen, collapse and warnings, as a document.
std::string json_in_short(const db::StoredTest& test);

}  // namespace triax::src
