// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a report says, before it is said as text, HTML or PDF: one source, three forms.
#include <string>
#include <vector>

#include "src/output/fact.hpp"
#include "src/output/table.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::src {

/// One test in full.
struct TestContent {
  std::string title;   ///< "Test 3: TMU-MT1"
  std::string banner;  ///< what a reader must not miss: SIMULATED, INTERRUPTED; empty if neither
  std::vector<Fact> facts;
  Table criteria;  ///< each criterion with its finding and evidence
  Table events;    ///< what happened, of which reading, when it was known, the evidence
  Table checks;    ///< measured, limit, ok, why
};

/// One row a test, like Table 2 of Darve, Sibille, Daouadji and Nicot (2007): type of test, test,
/// p'0 (kPa), e0, φ_mob (°), η at collapse; and origin, kind, limit surface, agreement.
Table summary_table(const std::vector<study::TestResult>& tests);

/// What the columns of the summary mean, one sentence each.
std::vector<std::string> summary_notes();

TestContent test_content(const study::TestResult& reported);

/// The same in short: what was stored and what it came to, without criteria and checks.
TestContent brief_content(const db::StoredTest& test);

}  // namespace triax::src
