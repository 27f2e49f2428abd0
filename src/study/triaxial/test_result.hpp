// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One test as a report needs it: what was stored, and its curves thinned for drawing.
#include <cstdint>
#include <string>
#include <vector>

#include "db/store.hpp"
#include "src/study/triaxial/curves.hpp"

namespace triax::study {

struct TestResult {
  db::StoredTest stored;
  /// Up to the last reading that can be believed; empty where the report draws no figure.
  Curves curves;
};

enum class WithCurves { no, yes };

/// Reads one test back from the store. With curves, every scan is visited once in constant memory.
TestResult load_test_result(const db::Store& store, std::int64_t id, WithCurves with_curves);

/// True once the verdict stands: a test that is running or was interrupted has none, and one of
/// which too little was seen.
bool has_verdict(const db::StoredTest& test);

/// Where collapse set in; nothing without a verdict and where strength was lost on the limit
/// surface only, which is failure and no collapse.
std::optional<lab::Instant> collapse_onset(const db::StoredTest& test);

/// Where strength was lost without a collapse: on the limit surface, or with the drainage open.
std::optional<lab::Instant> failure_onset(const db::StoredTest& test);

/// The true loss of control: where the first runaway of a simulated specimen began, as an instant
/// without a reading; what is not known is empty. Nothing without a runaway.
std::optional<lab::Instant> true_loss_of_control(const lab::Truth& truth);

/// When and at what stress the specimen of a simulation itself lost sustainability, as an instant
/// without a reading: no instrument sees it. Empty where it did not.
lab::Instant true_instant(const lab::Truth& truth);

/// The last reading on sensors that can be believed, where one failed; empty: all of them.
std::optional<std::int64_t> last_believed_reading(const db::StoredTest& test);

/// Void ratio at the start of shear, else as the laboratory gives it, else as built.
std::optional<double> void_ratio(const db::StoredTest& test);

/// Names of the criteria that detected a collapse, and how many were asked.
std::vector<std::string> agreeing_criteria(const db::StoredTest& test);

/// Of tests, each file once (read_again.hpp).
struct TestCounts {
  std::int64_t tests = 0;
  std::int64_t simulated = 0;
  std::int64_t interrupted = 0;
  std::int64_t read_again = 0;  ///< beside them: readings of a file that was read again
};
TestCounts counts_of(const std::vector<TestResult>& tests);

/// "line 12: ..." where a line is meant.
std::string in_words(const lab::Warning& warning);
/// Warnings of the record and of what followed in such words, each once.
std::vector<std::string> warnings(const db::StoredTest& test);

}  // namespace triax::study
