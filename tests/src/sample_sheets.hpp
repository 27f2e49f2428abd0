// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Invented tests as sheets need them.
#include "src/triaxial/sheet/report_sheets.hpp"
#include "tests/src/sample_tests.hpp"

namespace triax::src::test {

inline SheetTest sheet_of(TestResult result, const SheetRequest& request = {}) {
  SheetTest test{std::move(result), {}, {}};
  const auto& stored = test.result.stored;
  test.words = study::sheet_words(stored, request.said);
  auto options = request.options;
  if (const auto at = study::drained_at(test.words)) {
    options.drained_at = *at;
    options.boundary_is_said = true;
  }
  study::SheetReader reader(stored, options);
  for (const auto& state : test.result.curves.states) {
    lab::Reading reading;
    reading.si.fill(lab::kMissing);
    reading.number = state.reading;
    reading.time_s = state.time_s;
    reading.stage = state.stage;
    reader.add(reading, state);
  }
  test.values = reader.take();
  return test;
}

inline ReportSheets sheets_of(std::vector<TestResult> results, bool evidence = false) {
  ReportSheets sheets{.tests = {}, .evidence = evidence};
  for (auto& result : results) sheets.tests.push_back(sheet_of(std::move(result)));
  return sheets;
}

}  // namespace triax::src::test
